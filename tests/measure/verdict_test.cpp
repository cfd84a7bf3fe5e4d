// Verdicts on times whose truth is known, because they are made up.
#include "casegen/measure/verdict.h"

#include "casegen/random.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon::measure {
namespace {

using testing::error_of;
using ::testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

/// How a machine disturbs times.
struct Noise {
    double jitter = 0.02;  ///< standard deviation of a time's logarithm
    double hiccups = 0.05; ///< how often a time is several times as long
    double drift = 0.05;   ///< of the logarithm from round to round, for all times of a round
    bool cauchy = false;   ///< jitter with tails so heavy that it has no mean
};

double normal(Random& random) { // Box and Muller 1958
    const double u = 1 - random.unit(), v = random.unit();
    return std::sqrt(-2 * std::log(u)) * std::cos(6.283185307179586 * v);
}

PairedTimes draw(std::uint64_t seed, std::size_t rounds, double ratio, const Noise& noise, double floor = 0) {
    Random random(seed);
    PairedTimes times;
    times.floor = floor;
    double level = 0;
    for (std::size_t i = 0; i < rounds; ++i) {
        level += noise.drift * normal(random);
        const auto one = [&](double truth) {
            const double jitter =
                noise.cauchy ? std::tan(3.141592653589793 * (random.unit() - 0.5)) : normal(random);
            double logarithm = level + std::clamp(noise.jitter * jitter, -300.0, 300.0);
            if (random.chance(noise.hiccups)) logarithm += 2 * random.unit();
            return truth * std::exp(logarithm);
        };
        times.a.push_back(one(10));
        times.b.push_back(one(10 * ratio));
        times.again.push_back(one(10));
    }
    return times;
}

/// The verdict that `compare` comes to: looks until it is settled or the rounds are spent.
PaceVerdict look(std::uint64_t seed, double ratio, const Noise& noise, unsigned looks,
                 std::size_t* rounds = nullptr) {
    const PairedTimes all = draw(seed, rounds_at(looks), ratio, noise);
    PaceVerdict verdict;
    for (unsigned n = 1; n <= looks; ++n) {
        const auto first = [&](const std::vector<double>& of) {
            return std::vector<double>(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(rounds_at(n)));
        };
        PaceOptions options;
        options.look = n;
        verdict = judge_times({first(all.a), first(all.b), first(all.again), 0}, options);
        if (rounds) *rounds = rounds_at(n);
        if (settled(verdict, options)) break;
    }
    return verdict;
}

TEST(verdict, interval_of_the_median_has_the_ranks_of_the_tables) {
    // Conover, Practical Nonparametric Statistics: the largest k with P(Binomial(n, 1/2) < k) <= 2.5 %.
    const auto ranks = [](int n) {
        std::vector<double> values;
        for (int i = n; i >= 1; --i) values.push_back(i);
        const Interval interval = median_interval(values, 0.95);
        return std::pair(interval.lower, interval.upper);
    };
    EXPECT_EQ(ranks(6), std::pair(1.0, 6.0));
    EXPECT_EQ(ranks(9), std::pair(2.0, 8.0));
    EXPECT_EQ(ranks(10), std::pair(2.0, 9.0));
    EXPECT_EQ(ranks(20), std::pair(6.0, 15.0));
    EXPECT_EQ(ranks(100), std::pair(40.0, 61.0));
    for (int n = 0; n < 6; ++n) EXPECT_EQ(ranks(n), std::pair(-infinity, infinity)) << n;
}

TEST(verdict, interval_covers_the_median_as_often_as_it_says) {
    for (const std::size_t n : {7u, 16u, 50u}) {
        int covered = 0;
        for (std::uint64_t seed = 0; seed < 4000; ++seed) {
            Random random(seed, n);
            std::vector<double> values; // skewed: the median is 1, the mean infinite
            for (std::size_t i = 0; i < n; ++i) values.push_back(1 / random.unit() - 1);
            if (median_interval(values, 0.9).contains(1)) ++covered;
        }
        EXPECT_GE(covered, 3540) << n; // 3600 less three standard deviations
        EXPECT_LE(covered, 3960) << n; // and no interval that is merely wide
    }
}

TEST(verdict, a_program_against_itself_is_hardly_ever_faster_or_slower) {
    const std::vector<Noise> noises{
        {}, {0.1, 0.1, 0.1, false}, {0.05, 0.3, 0, false}, {0.02, 0, 0, true}, {0, 0, 0, false}};
    for (std::size_t n = 0; n < noises.size(); ++n) {
        int wrong = 0, same = 0;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            const Pace pace = look(seed, 1, noises[n], 5).pace;
            if (pace == Pace::faster || pace == Pace::slower) ++wrong;
            if (pace == Pace::same) ++same;
        }
        EXPECT_LE(wrong, 20) << "noise " << n;
        if (n == 0 || n >= 3) EXPECT_GE(same, 300) << "noise " << n;
    }
}

TEST(verdict, finds_ten_per_cent_in_little_noise_and_is_not_sure_in_much) {
    int slower = 0, faster = 0, wrong = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        if (look(seed, 1.1, {}, 4).pace == Pace::slower) ++slower;
        if (look(seed, 1 / 1.1, {}, 4).pace == Pace::faster) ++faster;
        const PaceVerdict noisy = look(seed, 1.1, {0.3, 0.2, 0.2, false}, 2);
        if (noisy.pace == Pace::faster || noisy.pace == Pace::same) ++wrong;
    }
    EXPECT_GE(slower, 190);
    EXPECT_GE(faster, 190);
    EXPECT_LE(wrong, 10);
}

TEST(verdict, is_not_moved_by_tails_that_move_a_mean) {
    int slower = 0;
    const Noise noise{0.01, 0.2, 0, true};
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        if (look(seed, 1.15, noise, 4).pace == Pace::slower) ++slower;
    EXPECT_GE(slower, 90);
}

TEST(verdict, never_calls_the_same_what_differs_by_more_than_the_margin) {
    int same = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const PaceVerdict verdict = look(seed, 1.06, {0.08, 0.1, 0.05, false}, 5);
        if (verdict.pace == Pace::same && verdict.margin < 0.06) ++same;
    }
    EXPECT_LE(same, 20);
}

TEST(verdict, a_machine_that_tells_copies_apart_widens_the_margin) {
    // Copies of one program differ by 5 % for good, with next to no noise on top: only A' shows it.
    PairedTimes times = draw(1, 64, 1.045, {0.001, 0, 0, false});
    PaceVerdict verdict = judge_times(times);
    EXPECT_EQ(verdict.pace, Pace::slower);
    for (double& time : times.again) time *= 1.05;
    verdict = judge_times(times);
    EXPECT_EQ(verdict.pace, Pace::same) << "no more than A differs from itself";
    EXPECT_GT(verdict.margin, 0.049);
    for (double& time : times.again) time *= 1.1;
    verdict = judge_times(times);
    EXPECT_EQ(verdict.pace, Pace::uncertain) << "a machine that shows 15 % cannot call anything the same";
    EXPECT_THAT(verdict.reason, HasSubstr("A differs from itself by up to 15"));
}

TEST(verdict, takes_reading_off) {
    // 7.5 of 10 are reading: 4 % more of the whole is 16 % more of the rest.
    PairedTimes times = draw(3, 64, 1.04, {0.001, 0, 0, false}, 7.5);
    for (std::size_t i = 0; i < times.a.size(); ++i) { // no drift, so that the floor is what it says
        times.a[i] = times.again[i] = 10 * (1 + 1e-4 * static_cast<double>(i % 7));
        times.b[i] = 10.4;
    }
    const PaceVerdict verdict = judge_times(times);
    EXPECT_NEAR(verdict.ratio, 1.16, 0.01);
    EXPECT_EQ(verdict.pace, Pace::slower);
    EXPECT_FALSE(verdict.with_floor);
    for (const double nearly_all : {8.1, 10.1}) { // of which nothing would be left
        times.floor = nearly_all;
        EXPECT_NEAR(judge_times(times).ratio, 1.04, 0.01);
        EXPECT_TRUE(judge_times(times).with_floor);
    }
    for (double& time : times.b) time = 2; // of which reading is nearly all, though it is little of A's
    times.floor = 1.9;
    EXPECT_TRUE(judge_times(times).with_floor);
    EXPECT_NEAR(judge_times(times).ratio, 0.2, 0.01);
    times.floor = 1;
    EXPECT_FALSE(judge_times(times).with_floor);
    EXPECT_NEAR(judge_times(times).ratio, 1.0 / 9, 0.01);
}

TEST(verdict, looks_cost_confidence) {
    const PairedTimes times = draw(4, 64, 1, {});
    double width = 0, errors = 0;
    for (unsigned n = 1; n <= 6; ++n) {
        PaceOptions options;
        options.look = n;
        const PaceVerdict verdict = judge_times(times, options);
        errors += 1 - verdict.confidence;
        EXPECT_GE(verdict.interval.upper - verdict.interval.lower, width) << n;
        width = verdict.interval.upper - verdict.interval.lower;
    }
    EXPECT_LT(errors, 0.05 + 1e-12);
    std::size_t rounds = 0;
    look(5, 3, {}, 5, &rounds);
    EXPECT_EQ(rounds, rounds_at(1)) << "a factor of 3 is seen at once";
}

TEST(verdict, rule_needs_the_whole_interval) {
    EXPECT_EQ(pace_of({0.99, 1.02}, 0.03), Pace::same);
    EXPECT_EQ(pace_of({0.99, 1.031}, 0.03), Pace::uncertain);
    EXPECT_EQ(pace_of({1.031, 1.2}, 0.03), Pace::slower);
    EXPECT_EQ(pace_of({1.029, 1.2}, 0.03), Pace::uncertain);
    EXPECT_EQ(pace_of({0.5, 0.97}, 0.03), Pace::faster);
    EXPECT_EQ(pace_of({0.5, 0.971}, 0.03), Pace::uncertain);
    EXPECT_EQ(pace_of({0.99, 1.02}, 0.2), Pace::uncertain);
    EXPECT_EQ(pace_of({0, infinity}, 0.03), Pace::uncertain);
    EXPECT_EQ(pace_of({nan, nan}, 0.03), Pace::uncertain);
}

TEST(verdict, refuses_what_is_no_time) {
    const PairedTimes good = draw(6, 16, 1, {});
    EXPECT_NO_THROW(judge_times(good));
    const auto refused = [&](auto change) {
        PairedTimes bad = good;
        change(bad);
        return error_of([&] { judge_times(bad); });
    };
    EXPECT_THAT(refused([](PairedTimes& t) { t.a[3] = 0; }), HasSubstr("A took 0 in round 3"));
    EXPECT_THAT(refused([](PairedTimes& t) { t.b[0] = nan; }), HasSubstr("B took nan in round 0"));
    EXPECT_THAT(refused([](PairedTimes& t) { t.again[15] = infinity; }), HasSubstr("A again took inf"));
    EXPECT_THAT(refused([](PairedTimes& t) { t.b[2] = -1; }), HasSubstr("B took -1"));
    EXPECT_THAT(refused([](PairedTimes& t) { t.b.pop_back(); }), HasSubstr("15 times of B in 16 rounds"));
    EXPECT_THAT(refused([](PairedTimes& t) { t.floor = nan; }), HasSubstr("floor"));
    EXPECT_THAT(error_of([] { judge_times({}); }), HasSubstr("no times"));
    EXPECT_EQ(judge_times({{1, 1}, {1, 1}, {1, 1}, 0}).pace, Pace::uncertain) << "two rounds say nothing";
}

} // namespace
} // namespace gnomon::measure
