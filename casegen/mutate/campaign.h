// Mutation testing: every mutant of some kernels put before the checks that should notice it, by worker
// processes, so that one which crashes a driver or does not end costs no more than its process.
#pragma once

#include "casegen/mutate/equivalent.h"
#include "casegen/mutate/examiner.h"
#include "casegen/mutate/mutant.h"

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::mutate {

struct CampaignOptions {
    ExaminerOptions examiner;
    std::vector<Operator> operators = all_operators();
    std::vector<Equivalent> equivalents;
    std::optional<std::size_t> limit; ///< only so many mutants: those with the smallest ids, always the same
    std::string only;                 ///< if not empty: the mutant of this id
    unsigned jobs = 0;                ///< worker processes; 0: one per core
    /// Seconds without an answer after which a worker is killed.
    double patience = 60;
    const std::atomic<bool>* stop = nullptr; ///< begins nothing new once it is true
};

enum class Fate {
    not_run,    ///< interrupted before, or its kernels fail unchanged
    killed,     ///< a check turned red, a driver crashed, or there was no end to it
    survived,   ///< every check that compiles it passes
    equivalent, ///< the same, and it is listed as equivalent
    tolerated,  ///< the same, and it is listed as tolerated
    same_code,
    stillborn,
};
const char* to_string(Fate fate);

struct MutantReport {
    Mutant mutant;
    Fate fate = Fate::not_run;
    const Case* by = nullptr; ///< whose check turned red
    std::string how;
    const Equivalent* listed = nullptr; ///< the options' entry of its id
};

struct KernelCount {
    const Case* kernel = nullptr;
    std::vector<std::size_t> mutants; ///< that count for it: numbers of CampaignReport::mutants
    std::size_t killed = 0, survived = 0, equivalent = 0, tolerated = 0, same_code = 0, stillborn = 0,
                not_run = 0;
    std::size_t total() const { return mutants.size(); }
    /// Killed of those that could be, if any could.
    std::optional<double> score() const;
};

struct CampaignReport {
    std::vector<MutantReport> mutants;
    std::vector<KernelCount> kernels;    ///< in the order of the cases; none for those that must fail
    KernelCount all;                     ///< every mutant once
    std::vector<const Case*> must_fail;  ///< kernels that are not mutated
    std::vector<std::string> complaints; ///< kernels that fail unchanged, entries of the list that are wrong
    double seconds = 0;
    bool interrupted = false;
    /// A mutant that was not run may survive.
    bool good() const { return complaints.empty() && all.survived == 0 && all.not_run == 0; }
};

/// The same for any number of jobs, but for the seconds. `done` is told how many mutants' fates are known,
/// and of how many. Forks: call it while this process has neither threads nor a device. Throws Error for what
/// concerns all of them: no device, no mutant of this id.
CampaignReport run_campaign(std::span<const Case* const> cases, const CampaignOptions& options,
                            const std::function<void(std::size_t done, std::size_t of)>& done = {});

} // namespace gnomon::mutate
