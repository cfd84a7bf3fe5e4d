// A fuzzing campaign: units of all kernels in turn, each on a worker that is a process of its own. A driver
// that crashes or a kernel that does not end costs that unit, is narrowed down to one input, and the campaign
// goes on. What was done and found is in a journal on disk at any time, so that an interrupted campaign is
// resumed by the same command.
#pragma once

#include "casegen/fuzz/unit.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::fuzz {

struct CampaignOptions {
    glsl::Sources sources; ///< frozen (see there): all workers see the same kernels, whenever they begin
    std::filesystem::path pins, worst;
    std::filesystem::path regressions; ///< folder that is read first, and written to; made if there is none
    std::filesystem::path journal;     ///< file; empty: none is kept
    std::string key;                   ///< campaign_key, for the journal
    /// Ends after about so many evaluations, shared among kernels by how fast their references are; else
    /// after so many seconds.
    std::optional<std::uint64_t> samples;
    double seconds = 60;
    std::uint64_t seed = 0;
    unsigned jobs = 0;                       ///< workers; 0: one per core
    std::uint64_t shard = 0, shards = 1;     ///< does the units whose number is `shard` modulo `shards`
    bool until_found = false;                ///< ends at the first failure
    gpu::DeviceOptions device;               ///< its time limit is what a batch may take
    const std::atomic<bool>* stop = nullptr; ///< ends the campaign once it becomes true
};

/// What became of one kernel.
struct KernelReport {
    const Case* kernel = nullptr;
    std::uint64_t evaluations = 0;
    double worst_error = 0;
    Input worst;          ///< if that is not 0
    std::string given_up; ///< why its later units were not run; empty if they were
};

struct Finding {
    Regression regression;
    std::filesystem::path
        file;           ///< where it is; empty for what no file can replay (a kernel that does not compile)
    bool known = false; ///< it was on file before
    std::uint64_t unit = 0;
};

struct CampaignReport {
    std::vector<KernelReport> kernels; ///< as given
    std::vector<Finding> findings;     ///< by kernel and failure
    std::uint64_t evaluations = 0, units = 0, resumed_units = 0;
    double seconds = 0;                ///< of this run
    std::uint64_t evaluations_now = 0; ///< in this run
    bool interrupted = false;
};

struct CampaignProgress {
    double seconds = 0, share = 0; ///< of the campaign that is done, 0 to 1
    std::uint64_t evaluations = 0; ///< in this run
    std::size_t findings = 0;
    const Case* worst_kernel = nullptr; ///< whose largest error is nearest to what its tolerance allows
    double worst_error = 0;
};

/// Forks: call it while this process has neither threads nor a device. For --samples the findings and all
/// numbers but times are the same for the same seed on any number of jobs, and the shards' together are the
/// whole. A failure's file is that of the lowest unit which met it. Throws Error: no folder, a malformed
/// regression, a journal of another campaign, no device.
CampaignReport run_campaign(std::span<const Case* const> cases, const CampaignOptions& options,
                            const std::function<void(const CampaignProgress&)>& progress = {});

/// A word for all that a campaign's units depend on: the kernels' text, what they are held against (this
/// program), fixed inputs, options. Only a journal with this word resumes it. (Regressions on file are not in
/// it: the campaign itself adds some.)
std::string campaign_key(std::span<const Case* const> cases, const CampaignOptions& options);

} // namespace gnomon::fuzz
