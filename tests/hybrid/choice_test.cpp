// The chooser, with times that are invented.
#include "runtime/error.h"
#include "runtime/hybrid/choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<Candidate> candidates(const std::vector<std::vector<double>>& times) {
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < times.size(); ++i)
        all.push_back({.name = fmt::format("{}", i), .milliseconds = times[i]});
    return all;
}

std::size_t choose(const std::vector<std::vector<double>>& times, double margin = 0.05) {
    return fastest(candidates(times), margin);
}

TEST(Choice, TakesTheFastest) {
    EXPECT_EQ(choose({{10}, {9}, {7}, {8}}), 2u);
    EXPECT_EQ(choose({{7}, {9}, {10}}), 0u);
}

TEST(Choice, KeepsTheFirstWithinTheMargin) {
    EXPECT_EQ(choose({{10.4}, {10}}), 0u);
    EXPECT_EQ(choose({{10.6}, {10}}), 1u);
    EXPECT_EQ(choose({{10.6}, {10}}, 0.1), 0u);
    EXPECT_EQ(choose({{10.1}, {10}}, 0), 1u);
}

TEST(Choice, TakesTheFirstOfTies) {
    EXPECT_EQ(choose({{5}, {5}, {5}}), 0u);
    EXPECT_EQ(choose({{9}, {5}, {5}}), 1u);
}

TEST(Choice, GoesByTheTypicalFrame) {
    // One frame that was disturbed, one that was lucky.
    EXPECT_EQ(choose({{10, 10, 10}, {7, 90, 7}}), 1u);
    EXPECT_EQ(choose({{10, 10, 10}, {1, 12, 12}}), 0u);
    EXPECT_EQ(typical_time({.name = {}, .milliseconds = {3, 1}}), 3); // of two, the greater
}

TEST(Choice, NeverTakesWhatHasNoTime) {
    EXPECT_EQ(choose({{10}, {nan}}), 0u);
    EXPECT_EQ(choose({{nan}, {10}}), 1u);
    EXPECT_EQ(choose({{10, 10, 10}, {nan, nan, 1}}), 0u);
    EXPECT_EQ(choose({{10}, {-1}}), 0u);
    EXPECT_EQ(choose({{10}, {}}), 0u);
    EXPECT_EQ(choose({{10, 10, 10}, {1}}), 0u) << "gave up after a round";
    EXPECT_EQ(choose({{1}, {2, 2, 2}}), 1u) << "the first is no exception";
    std::vector<Candidate> all = candidates({{10}, {5}});
    all[1].refused = "no memory";
    EXPECT_EQ(fastest(all, 0.05), 0u);
    all[0].refused = "no rays";
    EXPECT_THROW(fastest(all, 0.05), Error);
    EXPECT_THROW(fastest({}, 0.05), Error);
}

/// Frames of a machine on which candidate i takes times[i], and ten times as long at first.
struct Machine {
    std::vector<double> times;
    std::vector<int> frames{};
    std::vector<std::size_t> order{};

    double frame(std::size_t i) {
        frames.resize(times.size());
        order.push_back(i);
        return frames[i]++ == 0 ? 10 * times[i] : times[i];
    }
    Choice run(const CalibrationRules& rules = {}) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < times.size(); ++i) names.push_back(fmt::format("t{}", i));
        return calibrate(
            names, [this](std::size_t i) { return frame(i); }, rules);
    }
};

TEST(Calibration, DiscardsTheFirstRoundAndTakesTurns) {
    Machine machine{{10, 9, 9.5}};
    const Choice choice = machine.run({.rounds = 3});
    EXPECT_EQ(choice.name(), "t1");
    for (const Candidate& candidate : choice.candidates) EXPECT_EQ(candidate.milliseconds.size(), 3u);
    EXPECT_EQ(machine.order, (std::vector<std::size_t>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}));
    EXPECT_LT(typical_time(choice.candidates[0]), 11);
}

TEST(Calibration, TimesNoFurtherWhoIsFarBehind) {
    Machine machine{{10, 30, 11, 13}};
    const Choice choice = machine.run({.rounds = 5, .give_up = 1.25});
    EXPECT_EQ(choice.chosen, 0u);
    EXPECT_EQ(machine.frames, (std::vector<int>{6, 2, 6, 2}));
    Machine other{{30, 10}};
    EXPECT_EQ(other.run().chosen, 1u);
    EXPECT_EQ(other.frames, (std::vector<int>{2, 6}));
}

TEST(Calibration, TellsWhoRefused) {
    std::vector<int> calls(3);
    const Choice choice = calibrate({"a", "b", "c"}, [&](std::size_t i) {
        ++calls[i];
        if (i == 1) throw Error("needs a sun");
        return i == 0 ? 10.0 : 5.0;
    });
    EXPECT_EQ(choice.name(), "c");
    EXPECT_EQ(choice.candidates[1].refused, "needs a sun");
    EXPECT_TRUE(choice.candidates[1].milliseconds.empty());
    EXPECT_EQ(calls[1], 1);
    EXPECT_THROW(calibrate({"a"}, [](std::size_t) -> double { throw Error("no"); }), Error);
}

} // namespace
} // namespace gnomon
