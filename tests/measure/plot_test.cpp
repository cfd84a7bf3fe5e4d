#include "casegen/measure/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace gnomon::measure {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(plot, an_axis_holds_its_values_and_clamps_what_it_does_not) {
    const LogAxis axis{-8, -2, 300, 0};
    EXPECT_DOUBLE_EQ(axis(1e-8), 300);
    EXPECT_DOUBLE_EQ(axis(1e-5), 150);
    EXPECT_DOUBLE_EQ(axis(1e-2), 0);
    EXPECT_DOUBLE_EQ(axis(1), 0);
    EXPECT_DOUBLE_EQ(axis(0), 300);
    EXPECT_DOUBLE_EQ(axis(1e-20), 300);
    EXPECT_DOUBLE_EQ(axis(std::numeric_limits<double>::infinity()), 0);
    EXPECT_DOUBLE_EQ(axis(std::nan("")), 0);
}

TEST(plot, an_axis_takes_whole_decades_around_what_there_is) {
    const LogAxis axis = axis_around({3e-7, 0, 0.02, HUGE_VAL, std::nan("")}, -12, 6);
    EXPECT_EQ(axis.lower, -7);
    EXPECT_EQ(axis.upper, -1);
    EXPECT_EQ(axis_around({1e-30, 1e30}, -12, 6).lower, -12);
    EXPECT_EQ(axis_around({1e-30, 1e30}, -12, 6).upper, 6);
    for (const std::vector<double>& values : {std::vector<double>{}, {0.0}, {HUGE_VAL}, {1e-3}, {1e9}}) {
        const LogAxis some = axis_around(values, -12, 6);
        EXPECT_LT(some.lower, some.upper);
    }
}

TEST(plot, powers_of_ten_are_written_as_people_do) {
    EXPECT_EQ(power_of_ten(-12), "10⁻¹²");
    EXPECT_EQ(power_of_ten(3), "10³");
    EXPECT_EQ(power_of_ten(0), "1");
}

TEST(plot, text_cannot_break_a_picture) {
    Svg svg(10, 10);
    svg.text(1, 1, "a < b & \"c\"");
    svg.open_group("k < 1");
    svg.close_group();
    const std::string text = svg.finish("x & y");
    EXPECT_THAT(text, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
    EXPECT_THAT(text, HasSubstr("<title>k &lt; 1</title>"));
    EXPECT_THAT(text, Not(HasSubstr("x & y")));
}

TEST(plot, nine_colours_and_then_again) {
    std::set<std::string> colours;
    for (std::size_t n = 0; n < 9; ++n) colours.insert(colour(n));
    EXPECT_EQ(colours.size(), 9u);
    EXPECT_STREQ(colour(9), colour(0));
}

} // namespace
} // namespace gnomon::measure
