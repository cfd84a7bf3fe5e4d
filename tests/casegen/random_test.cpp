#include "casegen/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace gnomon {
namespace {

TEST(random, same_seed_and_stream_give_the_same_bits) {
    Random first(7, 3), second(7, 3);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(first.bits(), second.bits());
}

// Inputs in bug reports are named by seed and number: these bits may never change. (From a second
// implementation, in Python.)
TEST(random, golden_bits) {
    Random zero(0), named(0x123456789abcdef0, 42);
    EXPECT_EQ(zero.bits(), 13830413928045401970ull);
    EXPECT_EQ(zero.bits(), 6869446166584666695ull);
    EXPECT_EQ(named.bits(), 17094680098213353945ull);
    EXPECT_EQ(named.bits(), 2978231147773353133ull);
    EXPECT_EQ(named.below(1000), 625u);
    EXPECT_EQ(named.between(-50, 50), -38);
    EXPECT_EQ(named.unit(), 0x1.86cd32d735bfap-1);
}

TEST(random, seeds_and_streams_differ) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        for (std::uint64_t stream = 0; stream < 100; ++stream) seen.insert(Random(seed, stream).bits());
    EXPECT_EQ(seen.size(), 10000u);
}

TEST(random, below_is_even) {
    for (const std::uint32_t n : {2u, 3u, 7u, 10u}) {
        Random random(n);
        std::array<int, 10> counts{};
        const int draws = 100000;
        for (int i = 0; i < draws; ++i) {
            const std::uint32_t value = random.below(n);
            ASSERT_LT(value, n);
            ++counts[value];
        }
        const double expected = static_cast<double>(draws) / n, deviation = std::sqrt(expected);
        for (std::uint32_t value = 0; value < n; ++value)
            EXPECT_NEAR(counts[value], expected, 5 * deviation) << value << " of " << n;
    }
}

// A plain modulo would give the lower third of this range twice as often.
TEST(random, below_is_even_where_a_modulo_is_not) {
    Random random(11);
    const std::uint32_t n = 3u << 30;
    int low = 0;
    for (int i = 0; i < 30000; ++i) low += random.below(n) < n / 3 ? 1 : 0;
    EXPECT_NEAR(low, 10000, 5 * std::sqrt(10000.0 * 2 / 3));
}

TEST(random, below_one_is_zero) {
    Random random(1);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(random.below(1), 0u);
}

TEST(random, between_reaches_both_ends_and_no_further) {
    Random random(5);
    std::set<int> seen;
    for (int i = 0; i < 1000; ++i) seen.insert(random.between(-2, 3));
    EXPECT_EQ(seen, (std::set<int>{-2, -1, 0, 1, 2, 3}));
}

TEST(random, unit_is_in_the_half_open_interval_and_spread) {
    Random random(6);
    double sum = 0;
    for (int i = 0; i < 100000; ++i) {
        const double value = random.unit();
        ASSERT_GE(value, 0);
        ASSERT_LT(value, 1);
        sum += value;
    }
    EXPECT_NEAR(sum / 100000, 0.5, 0.005);
}

TEST(random, chance_of_zero_and_one) {
    Random random(8);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_FALSE(random.chance(0));
        ASSERT_TRUE(random.chance(1));
    }
}

} // namespace
} // namespace gnomon
