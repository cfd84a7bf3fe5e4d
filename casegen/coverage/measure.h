// Which lines and branches of kernels their inputs reach: the fixtures (what every check begins with:
// regressions, worst ones, pins, hostile and stiff values) alone, and the random samples behind them.
#pragma once

#include "casegen/check.h"
#include "casegen/coverage/instrument.h"
#include "casegen/standalone.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gnomon::coverage {

struct Options {
    CheckOptions check; ///< the inputs are those that check() judges
    bool only_fixtures = false;
};

/// By how many inputs something was reached.
struct Hits {
    std::uint64_t fixtures = 0, samples = 0;
    std::uint64_t all() const { return fixtures + samples; }
    friend bool operator==(const Hits&, const Hits&) = default;
};

/// One kernel's run.
struct KernelRun {
    const Case* kernel = nullptr;
    std::size_t fixtures = 0, samples = 0; ///< how many inputs were run
    /// Why nothing, or not everything, was counted: it does not compile, does not end, or gives other results
    /// with counters than without.
    std::string trouble;
    std::map<std::string, std::vector<Hits>> hits; ///< by file and counter
    /// By file and counter, where its fixtures reach nothing: the command that runs the first random sample
    /// that does.
    std::map<std::string, std::map<std::size_t, std::string>> replays;
    /// Counters that were left out, for with any one of them the driver rounds results otherwise: all counts
    /// are of the kernel as it is. (That it gives the same results with none of them active is required.)
    std::size_t left_out = 0;
};

/// A text that kernels were made of, and what all of them together reached in it.
struct FileCoverage {
    std::string name; ///< "smsr/case_09.glsl"; "<smsr/cases>" is a text that the program generates
    std::string text; ///< the author's
    Instrumented points;
    std::vector<Hits> hits;                     ///< by counter
    std::map<std::size_t, std::string> replays; ///< by counter, where no kernel's fixtures reach anything

    bool is_generated() const { return name.starts_with('<'); }
};

struct Coverage {
    std::vector<KernelRun> kernels;  ///< in the order in which they were asked for
    std::vector<FileCoverage> files; ///< by name, generated ones last
    bool only_fixtures = false;
};

/// Runs every kernel with counters and without, on the same inputs; results must be the same bits. `done` is
/// told of the inputs run so far, from worker threads, one at a time. A kernel that cannot be measured does
/// not stop the others. Same kernels, same counts, on any number of jobs. Throws Error as check() does.
Coverage measure(std::span<const Case* const> cases, const Options& options,
                 const std::function<void(std::size_t)>& done = {});

/// One kernel's, on inputs of the caller's, all of them counted as fixtures. `instrumenter` is instrument,
/// but for tests of what is reported if that changes a kernel.
using Instrumenter = std::function<Instrumented(std::string_view text, std::size_t first)>;
KernelRun measure_on(gpu::Device& device, const glsl::Sources& sources, const Case& c, const Records& records,
                     const Instrumenter& instrumenter = instrument);

/// Of all the runs' kernels, file by file.
std::vector<FileCoverage> merge(const glsl::Sources& sources, std::span<const KernelRun> runs);

/// Per line that holds something that counts: how often it was reached. Of several such things on one line
/// the most frequent says it.
std::map<int, Hits> line_hits(const FileCoverage& file);

/// Parts of a whole.
struct Share {
    std::size_t fixtures = 0, all = 0; ///< reached by the fixtures alone, and with the samples
    std::size_t of = 0;
    Share& operator+=(const Share& other);
};
struct Totals {
    Share lines, branches, functions; ///< a branch is one outcome
    Totals& operator+=(const Totals& other);
};
Totals totals(const FileCoverage& file);
Totals totals(const Coverage& coverage);

} // namespace gnomon::coverage
