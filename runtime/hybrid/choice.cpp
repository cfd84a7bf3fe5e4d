#include "runtime/hybrid/choice.h"

#include "runtime/error.h"

#include <algorithm>
#include <limits>

namespace gnomon {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double least_time(const Candidate& candidate) {
    double least = never;
    for (const double time : candidate.milliseconds)
        if (time < least) least = time; // NaN is not
    return candidate.refused.empty() ? least : never;
}

} // namespace

double typical_time(const Candidate& candidate) {
    if (!candidate.refused.empty() || candidate.milliseconds.empty()) return never;
    std::vector<double> times;
    for (const double time : candidate.milliseconds) times.push_back(time >= 0 ? time : never);
    std::ranges::sort(times);
    return times[times.size() / 2]; // of two, the greater: never better than it was seen
}

std::size_t fastest(std::span<const Candidate> candidates, double margin) {
    std::size_t rounds = 0, best = candidates.size();
    for (const Candidate& candidate : candidates) rounds = std::max(rounds, candidate.milliseconds.size());
    const auto time_of = [&](std::size_t i) {
        return candidates[i].milliseconds.size() == rounds ? typical_time(candidates[i]) : never;
    };
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (time_of(i) < never && (best == candidates.size() || time_of(i) < time_of(best))) best = i;
    if (best == candidates.size())
        throw Error("no exact technique can be taken here: {}",
                    candidates.empty() ? "there is none" : candidates.front().refused);
    return time_of(0) <= time_of(best) * (1 + margin) ? 0 : best;
}

Choice calibrate(const std::vector<std::string>& names, const std::function<double(std::size_t)>& frame,
                 const CalibrationRules& rules) {
    Choice choice;
    for (const std::string& name : names) choice.candidates.push_back({.name = name});
    std::vector<Candidate>& all = choice.candidates;
    for (std::size_t i = 0; i < all.size(); ++i) try {
            frame(i);
        } catch (const Error& error) {
            all[i].refused = error.what();
        }
    std::vector<bool> racing;
    for (const Candidate& candidate : all) racing.push_back(candidate.refused.empty());
    for (int round = 0; round < rules.rounds; ++round) {
        for (std::size_t i = 0; i < all.size(); ++i)
            if (racing[i]) all[i].milliseconds.push_back(frame(i));
        double least = never;
        for (const Candidate& candidate : all) least = std::min(least, least_time(candidate));
        for (std::size_t i = 0; i < all.size(); ++i)
            if (least_time(all[i]) > rules.give_up * least) racing[i] = false;
    }
    choice.chosen = fastest(all, rules.margin);
    return choice;
}

} // namespace gnomon
