// A resident check: every kernel once, then, on every save, the kernels whose code it changed.
//
// This process only reads files, expands includes and waits; kernels are compiled and run by worker
// processes, which are replaced when they crash or hang. A kernel keeps its worker, which holds its samples,
// its truths and the results of its last state. Times are taken by a process of their own once no verdict is
// due: the verdicts' code is compiled without optimising, because that is sooner there.
#pragma once

#include "casegen/check.h"
#include "casegen/watch/event.h"

#include <functional>
#include <optional>
#include <span>
#include <string>

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

/// Returns how many kernels are not known to be good in the end. Fork-safe callers only: no threads, no
/// device. Throws Error for what concerns all kernels (no such folder, no device, malformed regressions).
std::size_t run_session(std::span<const Case* const> cases, const SessionOptions& options,
                        const std::function<void(const Event&)>& tell);

} // namespace gnomon::watch
