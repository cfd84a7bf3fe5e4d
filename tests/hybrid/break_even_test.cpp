// The cost of a ray from which a hybrid pays, by the definition itself: at that cost both take as long.
#include "casegen/measure/hybrid/break_even.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon::measure {
namespace {

TEST(BreakEven, IsTheCostAtWhichBothTakeAsLong) {
    const FrameCost raytraced{.milliseconds = 12, .trace_milliseconds = 8, .rays = 200'000};
    const FrameCost hybrid{.milliseconds = 30, .trace_milliseconds = 2, .rays = 50'000};
    const double ns = break_even_nanoseconds(hybrid, raytraced);
    EXPECT_DOUBLE_EQ(ns, 160); // 24 ms for 150,000 rays
    const auto milliseconds_at = [](const FrameCost& cost, double per_ray) {
        return cost.overhead() + 1e-6 * per_ray * static_cast<double>(cost.rays);
    };
    EXPECT_NEAR(milliseconds_at(hybrid, ns), milliseconds_at(raytraced, ns), 1e-9);
    EXPECT_GT(milliseconds_at(hybrid, 0.9 * ns), milliseconds_at(raytraced, 0.9 * ns));
    EXPECT_LT(milliseconds_at(hybrid, 1.1 * ns), milliseconds_at(raytraced, 1.1 * ns));
}

TEST(BreakEven, IsNothingWhereTheHybridCostsNoMore) {
    EXPECT_EQ(break_even_nanoseconds({3, 1, 10}, {9, 5, 100}), 0);
    EXPECT_EQ(break_even_nanoseconds({5, 1, 10}, {9, 5, 100}), 0);
}

TEST(BreakEven, IsNeverReachedWithoutASavedRay) {
    EXPECT_TRUE(std::isinf(break_even_nanoseconds({20, 8, 100}, {12, 8, 100})));
    EXPECT_TRUE(std::isinf(break_even_nanoseconds({20, 8, 101}, {12, 8, 100})));
    EXPECT_TRUE(std::isinf(break_even_nanoseconds({2, 1, 101}, {12, 8, 100})))
        << "dearer the dearer a ray is";
    EXPECT_EQ(break_even_nanoseconds({12, 8, 100}, {12, 8, 100}), 0) << "itself";
}

TEST(FrameCost, SharesTracingAmongRays) {
    EXPECT_DOUBLE_EQ((FrameCost{12, 8, 200'000}.per_ray()), 40);
    EXPECT_EQ((FrameCost{12, 0, 0}.per_ray()), 0);
    EXPECT_DOUBLE_EQ((FrameCost{12, 8, 1}.overhead()), 4);
}

} // namespace
} // namespace gnomon::measure
