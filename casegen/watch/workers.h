// The processes that a session has run kernels: what crashes or hangs there is replaced.
#pragma once

#include "casegen/check.h"
#include "casegen/csv.h"
#include "casegen/watch/message.h"
#include "runtime/process.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gnomon::watch {

/// What every worker knows from the beginning. Outlives them.
struct Shared {
    std::vector<const Case*> cases;
    CheckOptions options;
    std::string folder; ///< what messages call the kernels' folder
    std::string replay; ///< what a replay command says besides
    std::shared_ptr<const EdgePool> pool;
    std::map<std::string, std::vector<CsvInput>> regressions; ///< of every kernel
};

/// A worker that answers a JudgeRequest with a Judgement. Its driver compiles without optimising
/// (GALLIVM_PERF=nopt, unless the environment has a value of it): half the time, the same bits.
Child start_judge(const Shared& shared);

/// One that answers a TimeRequest with Times: after `begin` of a kernel, `round` as often as one likes.
Child start_stopwatch(const Shared& shared);

} // namespace gnomon::watch
