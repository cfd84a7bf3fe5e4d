// What the resident process and its workers say to each other: JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::watch {

/// To a worker that judges.
struct JudgeRequest {
    std::size_t kernel = 0; ///< its number in the session
    std::string text;       ///< standalone_text
    std::string before;     ///< the one that results are compared with; empty: none ran before
};

/// How results differ from those of the state before.
struct Moved {
    std::size_t samples = 0; ///< whose bits are others
    double largest = 0;      ///< difference of a component; infinity where one of the two is no number
    std::string call, before, after; ///< where that is
};

/// What judging a state came to. One of: `cannot`, `same_code`, a verdict.
struct Judgement {
    std::string cannot;     ///< why nothing can be said, for a reason outside the kernel
    bool same_code = false; ///< the words are those of the state before: nothing was run

    std::string verdict; ///< as check says it, or "crash"
    bool good = false;
    bool ran = false;          ///< it has results, which the next state is compared with
    bool device_lost = false;  ///< the worker is of no more use
    std::uint64_t results = 0; ///< the hash of their bits; 0 if they may differ from run to run
    std::size_t samples = 0, failures = 0;
    std::optional<double> worst; ///< error, in the tolerance's unit
    std::string worst_call, got, want, message, replay;
    std::vector<std::string> explanation; ///< if it is not good: the lines that check prints
    std::optional<Moved> moved;           ///< if a state ran before
};

/// To the worker that keeps time: what it does next.
struct TimeRequest {
    enum class What { begin, round };
    What what = What::begin;
    std::size_t kernel = 0;
    std::string before, after; ///< repeated texts
    std::string alone;         ///< the standalone text of `after`, for its results
    std::uint64_t results = 0; ///< their hash as the judge had it; 0: do not compare
    unsigned round = 0;
};

/// Nanoseconds per evaluation of one round; of `begin` none yet. `floor`: of reading the inputs alone.
struct Times {
    std::string cannot;
    bool device_lost = false;
    bool same_results = true; ///< the optimising compiler's bits are those that were judged
    double before = 0, after = 0, again = 0, floor = 0;
};

std::string format(const JudgeRequest& request);
std::string format(const Judgement& judgement);
std::string format(const TimeRequest& request);
std::string format(const Times& times);
JudgeRequest parse_judge_request(const std::string& text);
Judgement parse_judgement(const std::string& text);
TimeRequest parse_time_request(const std::string& text);
Times parse_times(const std::string& text);

} // namespace gnomon::watch
