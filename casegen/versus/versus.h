// Two sides, kernel by kernel: which of them are other code, and what that changes. Everything that may hang
// or crash is done by a child process, so that it costs the kernel it happened in, and is told of its side.
#pragma once

#include "casegen/versus/examiner.h"

#include <functional>
#include <string>
#include <vector>

namespace gnomon::versus {

/// What there is to be compared.
struct Plan {
    std::vector<Pair> pairs; ///< there on both sides, and, unless a kernel was named, of another text
    std::size_t same = 0;    ///< kernels of the same text
    std::vector<std::string> only_a, only_b; ///< kernels that one side lacks
    std::vector<std::string> others; ///< files on both sides that are no kernels, include none, and differ
    bool named = false;              ///< a kernel was named: it is compared whatever its text is
};

/// If either side names a kernel, that one (two with one signature, if each names another); else those that
/// `pattern` names (see find_cases), or all. Reads texts, and compiles nothing. Throws Error: `pattern`
/// beside a named kernel, two kernels that take different parameters, nothing on both sides.
Plan make_plan(const Side& a, const Side& b, const std::string& pattern);

struct VersusOptions {
    ExaminerOptions examiner;
    bool times = true;
    bool picture = false;
};

struct VersusReport {
    std::vector<Comparison> comparisons;
    std::size_t same = 0; ///< with those of another text that compile to the same code
};

/// Forks: call it while this process has neither threads nor a device. `done` is told how many pairs are done
/// with. Throws
/// Error for what concerns all kernels (no device).
VersusReport run_plan(const Side& a, const Side& b, const Plan& plan, const VersusOptions& options,
                      const std::function<void(std::size_t)>& done = {});

} // namespace gnomon::versus
