#include "casegen/compare.h"

#include "casegen/random.h"
#include "tests/support/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

namespace gnomon {
namespace {

using testing::bits;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// A kernel of one float in [0,1] whose results may lie in [-1000, 1000].
template <typename Function>
Case make_case(Function reference, Tolerance tolerance) {
    Case c;
    c.name = "test/case";
    c.reference = reference;
    c.parameters = {{"x", {0, 1, {}}, "1", "input"}};
    c.result = {-1000, 1000, "1", "output"};
    c.tolerance = tolerance;
    return c;
}

Agreement judge_at(const Case& c, double x, std::uint32_t result) {
    Arguments arguments;
    arguments.numbers[0] = x;
    return judge(c, arguments, std::span(&result, 1));
}
Agreement judge_at(const Case& c, double x, float result) { return judge_at(c, x, bits(result)); }

double third(double) { return 1.0 / 3; }
double not_a_number(double) { return std::nan(""); }
double step_at_half(double x) { return x < 0.5 ? 0 : 1; }
double identity(double x) { return x; }

const Tolerance all_kinds[] = {exact(), ulps(3), absolute(1e-3), input_within(1e-3)};

float next(float value, int count) {
    for (; count > 0; --count) value = std::nextafter(value, infinity);
    for (; count < 0; ++count) value = std::nextafter(value, -infinity);
    return value;
}

TEST(judge, asks_for_the_last_bit_where_nothing_is_rounded) {
    for (const Tolerance& tolerance : all_kinds) {
        Case c = make_case(step_at_half, tolerance);
        c.exact_where = on_grid;
        EXPECT_TRUE(judge_at(c, 0.5, 1.0f).pass) << to_string(tolerance);
        EXPECT_FALSE(judge_at(c, 0.5, 0.0f).pass) << to_string(tolerance);
        EXPECT_GT(judge_at(c, 0.5, 0.0f).error, 0);
        Case smooth = make_case(identity, tolerance);
        smooth.exact_where = on_grid;
        EXPECT_TRUE(judge_at(smooth, 0.75, 0.75f).pass) << to_string(tolerance);
        EXPECT_FALSE(judge_at(smooth, 0.75, next(0.75f, 1)).pass) << to_string(tolerance);
    }
    Case c = make_case(step_at_half, input_within(1e-3));
    c.exact_where = on_grid;
    const double off_grid = 0.5 + 0x1p-23;
    EXPECT_TRUE(judge_at(c, off_grid, 0.0f).pass) << "where something may be rounded the tolerance counts";
    c.exact_where = nullptr;
    EXPECT_TRUE(judge_at(c, 0.5, 0.0f).pass);
}

TEST(on_grid, is_a_multiple_of_a_power_of_two) {
    const auto is = [](std::vector<double> numbers) { return on_grid(numbers); };
    EXPECT_TRUE(is({}));
    EXPECT_TRUE(is({0, 1, -3, 0.375, 0x1p-22}));
    EXPECT_FALSE(is({0, 0x1p-23}));
    EXPECT_FALSE(is({0.1}));
    EXPECT_FALSE(is({std::nan("")}));
}

TEST(ulps_between, counts_floats) {
    EXPECT_EQ(ulps_between(1.0f, 1.0f), 0);
    EXPECT_EQ(ulps_between(1.0f, next(1.0f, 1)), 1);
    EXPECT_EQ(ulps_between(1.0f, next(1.0f, -5)), 5);
    EXPECT_EQ(ulps_between(next(0.0f, 2), next(0.0f, -3)), 5); // across zero
    EXPECT_EQ(ulps_between(-FLT_TRUE_MIN, 0.0f), 1);
    EXPECT_EQ(ulps_between(FLT_MAX, -FLT_MAX), 2.0 * 0x7f7fffff);
}

TEST(ulps_between, zeros_are_equal) {
    EXPECT_EQ(ulps_between(0.0f, -0.0f), 0);
    EXPECT_EQ(ulps_between(-0.0f, FLT_TRUE_MIN), 1);
}

TEST(ulps_between, nan_and_infinity_are_infinitely_far) {
    EXPECT_EQ(ulps_between(nan, nan), HUGE_VAL);
    EXPECT_EQ(ulps_between(nan, 0.0f), HUGE_VAL);
    EXPECT_EQ(ulps_between(0.0f, nan), HUGE_VAL);
    EXPECT_EQ(ulps_between(infinity, FLT_MAX), HUGE_VAL);
    EXPECT_EQ(ulps_between(infinity, -infinity), HUGE_VAL);
    EXPECT_EQ(ulps_between(infinity, infinity), 0);
}

TEST(ulps_between, is_symmetric_and_agrees_with_stepping) {
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const auto a = static_cast<float>(random.unit() * 2 - 1);
        const int steps = random.between(-20, 20);
        ASSERT_EQ(ulps_between(a, next(a, steps)), std::abs(steps));
        ASSERT_EQ(ulps_between(next(a, steps), a), std::abs(steps));
    }
}

TEST(judge, exact_takes_the_rounded_reference_and_nothing_else) {
    const Case c = make_case(third, exact());
    EXPECT_TRUE(judge_at(c, 0, 1.0f / 3).pass);
    EXPECT_EQ(judge_at(c, 0, 1.0f / 3).error, 0);
    EXPECT_FALSE(judge_at(c, 0, next(1.0f / 3, 1)).pass);
    EXPECT_FALSE(judge_at(c, 0, next(1.0f / 3, -1)).pass);
    EXPECT_GT(judge_at(c, 0, next(1.0f / 3, 1)).error, 0);
}

TEST(judge, ulps_takes_as_many_as_allowed) {
    const Case c = make_case(third, ulps(3));
    for (const int steps : {-3, -1, 0, 2, 3}) {
        EXPECT_TRUE(judge_at(c, 0, next(1.0f / 3, steps)).pass) << steps;
        EXPECT_EQ(judge_at(c, 0, next(1.0f / 3, steps)).error, std::abs(steps));
    }
    EXPECT_FALSE(judge_at(c, 0, next(1.0f / 3, 4)).pass);
    EXPECT_FALSE(judge_at(c, 0, next(1.0f / 3, -4)).pass);
    EXPECT_FALSE(judge_at(c, 0, -1.0f / 3).pass);
}

TEST(judge, absolute_takes_as_much_as_allowed) {
    const Case c = make_case(identity, absolute(0.25));
    EXPECT_TRUE(judge_at(c, 0.5, 0.75f).pass);
    EXPECT_TRUE(judge_at(c, 0.5, 0.25f).pass);
    EXPECT_EQ(judge_at(c, 0.5, 0.75f).error, 0.25);
    EXPECT_FALSE(judge_at(c, 0.5, next(0.75f, 1)).pass);
    EXPECT_FALSE(judge_at(c, 0.5, next(0.25f, -1)).pass);
}

TEST(judge, input_within_takes_what_a_near_input_gives) {
    const Case c = make_case(step_at_half, input_within(1e-3));
    EXPECT_TRUE(judge_at(c, 0.5, 1.0f).pass);
    EXPECT_EQ(judge_at(c, 0.5, 1.0f).error, 0);
    EXPECT_TRUE(judge_at(c, 0.5, 0.0f).pass); // half minus a little gives 0
    EXPECT_GT(judge_at(c, 0.5, 0.0f).error, 0);
    EXPECT_TRUE(judge_at(c, 0.5 - 0.99e-3, 1.0f).pass);
    EXPECT_TRUE(judge_at(c, 0.5 + 0.99e-3, 0.0f).pass);
    EXPECT_LE(judge_at(c, 0.5 + 0.99e-3, 0.0f).error, 1e-3);
}

TEST(judge, input_within_refuses_what_only_a_farther_input_gives) {
    const Case c = make_case(step_at_half, input_within(1e-3));
    EXPECT_FALSE(judge_at(c, 0.5 - 1.01e-3, 1.0f).pass);
    EXPECT_FALSE(judge_at(c, 0.5 + 1.01e-3, 0.0f).pass);
    EXPECT_FALSE(judge_at(c, 0, 1.0f).pass);
    EXPECT_FALSE(judge_at(c, 0.5, 0.5f).pass); // no input gives this
    EXPECT_EQ(judge_at(c, 0, 1.0f).error, HUGE_VAL);
}

TEST(judge, input_within_moves_all_float_inputs_and_no_others) {
    Case c;
    c.name = "test/case";
    c.reference = [](double x, double y, int n) { return x + y + n < 1 ? 0.0 : 1.0; };
    c.parameters = {{"x", {0, 1, {}}, "", ""}, {"y", {0, 1, {}}, "", ""}, {"n", {0, 1, {}}, "", ""}};
    c.result = {0, 1, "", ""};
    c.tolerance = input_within(0.125);
    const auto pass = [&](double x, double y, double n, float result) {
        Arguments arguments;
        arguments.numbers = {x, y, n};
        const std::uint32_t word = bits(result);
        return judge(c, arguments, std::span(&word, 1)).pass;
    };
    EXPECT_TRUE(pass(0.5, 0.25, 0, 1.0f));    // both moved by 0.125
    EXPECT_FALSE(pass(0.5, 0.1875, 0, 1.0f)); // too far for both
    EXPECT_FALSE(pass(0.25, 0.25, 1, 0.0f));  // a smaller n would do, but whole numbers stand still
}

TEST(judge, a_nan_result_never_passes) {
    for (const Tolerance& tolerance : all_kinds) {
        EXPECT_FALSE(judge_at(make_case(third, tolerance), 0, nan).pass) << to_string(tolerance);
        EXPECT_FALSE(judge_at(make_case(third, tolerance), 7, nan).pass) << "outside the domain";
        EXPECT_FALSE(judge_at(make_case(not_a_number, tolerance), 0, nan).pass) << "where it is wanted";
        EXPECT_EQ(judge_at(make_case(third, tolerance), 0, nan).error, HUGE_VAL);
    }
    EXPECT_FALSE(judge_at(make_case(third, absolute(HUGE_VAL)), 0, nan).pass);
    EXPECT_FALSE(judge_at(make_case(third, ulps(HUGE_VAL)), 0, nan).pass);
}

TEST(judge, a_nan_reference_never_passes) {
    for (const Tolerance& tolerance : all_kinds)
        EXPECT_FALSE(judge_at(make_case(not_a_number, tolerance), 0, 0.5f).pass) << to_string(tolerance);
    EXPECT_FALSE(judge_at(make_case(not_a_number, absolute(HUGE_VAL)), 0, 0.5f).pass);
    EXPECT_FALSE(judge_at(make_case(not_a_number, ulps(HUGE_VAL)), 0, 0.5f).pass);
    // Nor where a near input would give a number.
    const Case c = make_case([](double x) { return x == 0.5 ? std::nan("") : 0.25; }, input_within(1e-3));
    EXPECT_FALSE(judge_at(c, 0.5, 0.25f).pass);
    EXPECT_TRUE(judge_at(c, 0.25, 0.25f).pass);
}

TEST(judge, results_outside_their_range_fail_inside_the_domain_and_outside) {
    for (const Tolerance& tolerance : all_kinds)
        for (const float result : {1000.5f, -1000.5f, infinity, -infinity})
            for (const double x : {0.5, 2.0, -1.0, std::nan(""), HUGE_VAL}) {
                EXPECT_FALSE(judge_at(make_case(identity, tolerance), x, result).pass) << x << " " << result;
                EXPECT_EQ(judge_at(make_case(identity, tolerance), x, result).error, HUGE_VAL);
            }
    EXPECT_FALSE(judge_at(make_case([](double) { return 2000.0; }, absolute(1)), 0, 2000.0f).pass)
        << "even if the reference agrees";
}

TEST(judge, outside_the_domain_only_the_range_counts) {
    const Case c = make_case(identity, exact());
    EXPECT_TRUE(judge_at(c, 2.0, -7.0f).pass);
    EXPECT_TRUE(judge_at(c, std::nan(""), 7.0f).pass);
    EXPECT_FALSE(judge_at(c, 1.0, 0.5f).pass); // the border belongs to the domain
}

TEST(judge, where_narrows_the_domain) {
    Case c = make_case(identity, exact());
    c.where = [](const Arguments& a) { return a.numbers[0] != 0.5; };
    EXPECT_TRUE(judge_at(c, 0.5, 0.0f).pass);
    EXPECT_FALSE(judge_at(c, 0.25, 0.0f).pass);
}

TEST(judge, zeros_of_either_sign_agree) {
    for (const Tolerance& tolerance : all_kinds) {
        const Case c = make_case(identity, tolerance);
        EXPECT_TRUE(judge_at(c, 0.0, -0.0f).pass) << to_string(tolerance);
        EXPECT_TRUE(judge_at(c, -0.0, 0.0f).pass) << to_string(tolerance);
    }
}

TEST(judge, every_component_counts) {
    Case c = make_case([](double x) { return glm::dvec2(x, 1 - x); }, exact());
    const auto pass = [&](float a, float b) {
        Arguments arguments;
        arguments.numbers[0] = 0.25;
        const std::uint32_t words[2] = {bits(a), bits(b)};
        return judge(c, arguments, words).pass;
    };
    EXPECT_TRUE(pass(0.25f, 0.75f));
    EXPECT_FALSE(pass(0.5f, 0.75f));
    EXPECT_FALSE(pass(0.25f, 0.5f));
    EXPECT_FALSE(pass(0.25f, nan));
    EXPECT_FALSE(pass(nan, 0.75f));
}

TEST(judge, whole_numbers_are_compared_as_such) {
    Case c = make_case([](double) { return -1; }, exact());
    EXPECT_TRUE(judge_at(c, 0, std::bit_cast<std::uint32_t>(-1)).pass);
    EXPECT_FALSE(judge_at(c, 0, std::bit_cast<std::uint32_t>(-2)).pass);
    c.reference = [](double) { return true; };
    c.result = {0, 1, "", ""};
    EXPECT_TRUE(judge_at(c, 0, 1u).pass);
    EXPECT_FALSE(judge_at(c, 0, 0u).pass);
    EXPECT_FALSE(judge_at(c, 0, 2u).pass);
    c.reference = [](double) { return 0x80000000u; };
    c.result = {0, 0xffffffff, "", ""};
    EXPECT_TRUE(judge_at(c, 0, 0x80000000u).pass);
    EXPECT_FALSE(judge_at(c, 0, 0x80000001u).pass);
}

} // namespace
} // namespace gnomon
