// What a fuzzing campaign found: while it runs, and in the end.
#pragma once

#include "casegen/fuzz/campaign.h"

#include <chrono>
#include <string>

namespace gnomon::cli {

/// A line on standard error with evaluations per second, findings, the error nearest to what is allowed, and
/// the time left; every ten seconds a new one where standard error is no terminal.
class FuzzProgress {
public:
    FuzzProgress();
    ~FuzzProgress();
    FuzzProgress(const FuzzProgress&) = delete;
    FuzzProgress& operator=(const FuzzProgress&) = delete;

    void show(const fuzz::CampaignProgress& now);

private:
    bool terminal_, shown_ = false;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A row per kernel, then each failure with call, got, want, its file and the command that replays it.
std::string fuzz_text(const fuzz::CampaignReport& report, const fuzz::CampaignOptions& options,
                      const std::string& replay);
std::string fuzz_json(const fuzz::CampaignReport& report, const fuzz::CampaignOptions& options);

} // namespace gnomon::cli
