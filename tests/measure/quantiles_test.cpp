#include "casegen/measure/quantiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon::measure {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(quantiles, are_values_at_their_ranks) {
    std::vector<double> values;
    for (int i = 100; i >= 1; --i) values.push_back(i);
    const Quantiles q = quantiles(values);
    EXPECT_EQ(q.median, 50);
    EXPECT_EQ(q.p90, 90);
    EXPECT_EQ(q.p99, 99);
    EXPECT_EQ(q.most, 100);
    EXPECT_EQ(q.count, 100u);
    EXPECT_EQ(q.non_finite, 0u);
    for (int n = 1; n < 300; ++n) { // no rank is lost to rounding
        std::vector<double> ranks;
        for (int i = 1; i <= n; ++i) ranks.push_back(i);
        ASSERT_EQ(quantile(ranks, 0.9), (9 * n + 9) / 10) << n;
    }
}

TEST(quantiles, of_few_values_are_some_of_them) {
    const Quantiles one = quantiles({3});
    EXPECT_EQ(one.median, 3);
    EXPECT_EQ(one.p99, 3);
    EXPECT_EQ(quantiles({1, 2}).median, 1);
    EXPECT_EQ(quantiles({1, 2}).p90, 2);
    EXPECT_EQ(quantiles({}).count, 0u);
    EXPECT_EQ(quantiles({}).most, 0);
}

TEST(quantiles, what_is_not_finite_is_larger_than_everything_and_never_dropped) {
    const Quantiles q = quantiles({1, nan, 2, infinity, 3, nan, 4, 5, 6, 7});
    EXPECT_EQ(q.count, 10u);
    EXPECT_EQ(q.non_finite, 3u);
    EXPECT_DOUBLE_EQ(q.non_finite_share(), 0.3);
    EXPECT_EQ(q.median, 5);
    EXPECT_EQ(q.p90, infinity);
    EXPECT_EQ(q.most, infinity);
    EXPECT_EQ(quantiles({nan, nan, 1}).median, infinity);
    EXPECT_EQ(quantiles({-infinity}).most, infinity); // an error that is none, whatever its sign
}

// More NaN can make no quantile smaller.
TEST(quantiles, nan_never_helps) {
    std::vector<double> values;
    for (int i = 0; i < 40; ++i) values.push_back(i % 7);
    Quantiles before = quantiles(values);
    for (int i = 0; i < 40; ++i) {
        values[static_cast<std::size_t>(i)] = nan;
        const Quantiles after = quantiles(values);
        EXPECT_GE(after.median, before.median);
        EXPECT_GE(after.p90, before.p90);
        EXPECT_GE(after.p99, before.p99);
        EXPECT_GE(after.most, before.most);
        before = after;
    }
    EXPECT_EQ(before.non_finite_share(), 1);
}

} // namespace
} // namespace gnomon::measure
