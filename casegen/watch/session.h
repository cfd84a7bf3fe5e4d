// A resident check: every kernel once, then, on every save, the kernels whose code it changed.
//
// This process only reads files, expands includes and waits; kernels are compiled and run by worker
// processes, which are replaced when they crash or hang. A kernel keeps its worker, which holds its samples,
// its truths and the results of its last state. Times are taken by a process of their own once no verdict is
// due: the verdicts' code is compiled without optimising, because that is sooner there.
#pragma once

#include "casegen/check.h"
#include "casegen/measure/verdict.h"
#include "casegen/watch/message.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace gnomon::watch {

struct SessionOptions {
    CheckOptions check; ///< `jobs`: worker processes; `samples`: at most most_samples
    std::string replay; ///< what a replay command says besides, see replay_command
    bool times = true;
    bool poll = false;                ///< files, instead of being told by inotify
    std::optional<std::size_t> edits; ///< ends after so many, when all is said about them
    int stop = -1;                    ///< a descriptor that is readable when the session is to end; -1: none
};

/// Samples stay in memory.
constexpr std::size_t most_samples = std::size_t{1} << 20;

// What there is to tell. An edit is whatever changed at once and changed at least one kernel's text; the
// first check is edit 0. Milliseconds count from when the change was seen.

struct Began {
    std::size_t kernels = 0;
    unsigned workers = 0;
    bool polls = false; ///< the folder; else inotify tells
};
struct Judged {
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    Judgement judgement;                ///< never of the same code
    std::optional<double> worst_before; ///< of the last state that ran
    double milliseconds = 0;
};
struct SameCode { ///< the text is another, what it compiles to is not
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    bool good = false; ///< as it was
    double milliseconds = 0;
};
struct Timed {
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    double before = 0, after = 0; ///< nanoseconds per evaluation: medians, with reading the inputs
    double reading = 0;           ///< of them for reading alone
    bool with_reading = false;    ///< `pace` compares them so: without, nothing would be left
    measure::PaceVerdict pace;
    bool same_results = true; ///< optimised code gives the bits that were judged
};
struct NotTimed {
    const Case* kernel = nullptr;
    std::size_t edit = 0;
    std::string why;
};
/// No verdict is due any more.
struct Settled {
    std::size_t edit = 0, judged = 0, same = 0; ///< kernels since the last one
    std::size_t good = 0, bad = 0;              ///< of all
    double milliseconds = 0;
};
using Event = std::variant<Began, Judged, SameCode, Timed, NotTimed, Settled>;

/// Returns how many kernels are not known to be good in the end. Fork-safe callers only: no threads, no
/// device. Throws Error for what concerns all kernels (no such folder, no device, malformed regressions).
std::size_t run_session(std::span<const Case* const> cases, const SessionOptions& options,
                        const std::function<void(const Event&)>& tell);

} // namespace gnomon::watch
