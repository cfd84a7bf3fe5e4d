// Results judged by what rounding their inputs does: unit_of_error and the tolerance `conditioned`.
#include "casegen/compare.h"

#include "casegen/catalogue.h"
#include "casegen/check.h"

#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Truth one_known_to_a_thousandth(const Arguments&) { return {{1}, {0x1p-10}, 1}; }
Truth one_known_exactly(const Arguments&) { return {{1}, {0}, 1}; }
Truth nothing(const Arguments&) { return {{0}, {0}, 0}; }
Truth no_value(const Arguments&) { return {{std::nan("")}, {0x1p-10}, 1}; }
Truth no_conditioning(const Arguments&) { return {{1}, {std::nan("")}, 1}; }
Truth no_scale(const Arguments&) { return {{1}, {0x1p-10}, std::nan("")}; }
Truth two_components(const Arguments&) { return {{1, 2}, {0x1p-10, 0x1p-20}, 2}; }

template <typename Signature = double(double)>
Case make_case(Truth (*truth)(const Arguments&), double times) {
    Case c;
    c.name = "test/conditioned";
    c.reference = reference_by<Signature>(truth);
    c.parameters = {{"x", {0, 1, {}}, "1", "input"}};
    c.result = {-1000, 1000, "1", "output"};
    c.tolerance = conditioned(times);
    return c;
}

Agreement judge_at(const Case& c, double x, float result, const Truth* known = nullptr) {
    Arguments arguments;
    arguments.numbers[0] = x;
    const auto word = std::bit_cast<std::uint32_t>(result);
    return judge(c, arguments, std::span(&word, 1), known);
}

TEST(conditioned, takes_as_many_units_as_allowed_and_no_more) {
    const Case c = make_case(one_known_to_a_thousandth, 4);
    for (const int units : {-4, -1, 0, 3, 4}) {
        const float result = 1 + static_cast<float>(units) * 0x1p-10f;
        EXPECT_TRUE(judge_at(c, 0.5, result).pass) << units;
        EXPECT_EQ(judge_at(c, 0.5, result).error, std::abs(units));
    }
    EXPECT_FALSE(judge_at(c, 0.5, std::nextafter(1 + 4 * 0x1p-10f, infinity)).pass);
    EXPECT_FALSE(judge_at(c, 0.5, std::nextafter(1 - 4 * 0x1p-10f, -infinity)).pass);
    EXPECT_EQ(judge_at(c, 0.5, 2).error, 1024);
}

TEST(conditioned, takes_a_truth_that_is_at_hand_for_its_own) {
    const Case c = make_case(one_known_to_a_thousandth, 1);
    const Truth known{{3}, {0.25}, 3};
    EXPECT_TRUE(judge_at(c, 0.5, 3.25f, &known).pass);
    EXPECT_FALSE(judge_at(c, 0.5, 1, &known).pass);
}

TEST(conditioned, asks_for_no_less_than_a_rounding_of_the_scale) {
    const Case c = make_case(one_known_exactly, 2);
    EXPECT_TRUE(judge_at(c, 0.5, 1 - 0x1p-23f).pass); // two roundings of 1
    EXPECT_EQ(judge_at(c, 0.5, 1 - 0x1p-23f).error, 2);
    EXPECT_FALSE(judge_at(c, 0.5, 1 + 2 * 0x1p-23f).pass);
    EXPECT_EQ(unit_of_error({{1}, {0}, 1}, 0), 0x1p-24);
    EXPECT_EQ(unit_of_error({{1}, {0x1p-30}, 1}, 0), 0x1p-24);
    EXPECT_EQ(unit_of_error({{1}, {0x1p-20}, 1}, 0), 0x1p-20);
}

TEST(conditioned, asks_for_no_less_than_the_smallest_normal_float) {
    const Case c = make_case(nothing, 1);
    EXPECT_EQ(unit_of_error({{0}, {0}, 0}, 0), static_cast<double>(FLT_MIN));
    EXPECT_TRUE(judge_at(c, 0.5, 0).pass);
    EXPECT_TRUE(judge_at(c, 0.5, -0.0f).pass);
    EXPECT_TRUE(judge_at(c, 0.5, FLT_MIN).pass); // what a device that flushes to zero may make of it
    EXPECT_FALSE(judge_at(c, 0.5, 2 * FLT_MIN).pass);
}

TEST(conditioned, a_truth_that_is_none_agrees_with_nothing) {
    for (const auto& truth : {no_value, no_conditioning, no_scale})
        for (const float result : {0.0f, 1.0f, nan, infinity}) {
            // A scale that is none leaves the conditioning to be taken, and never makes a wrong result right.
            const Agreement agreement = judge_at(make_case(truth, HUGE_VAL), 0.5, result);
            if (truth == no_scale && result < 2) continue;
            EXPECT_FALSE(agreement.pass) << result;
            EXPECT_EQ(agreement.error, HUGE_VAL);
        }
    EXPECT_FALSE(judge_at(make_case(no_scale, 4), 0.5, 0).pass);
}

TEST(conditioned, a_result_that_is_no_number_never_passes) {
    for (const double times : {1.0, 1e30, HUGE_VAL})
        for (const float result : {nan, infinity, -infinity}) {
            EXPECT_FALSE(judge_at(make_case(one_known_to_a_thousandth, times), 0.5, result).pass);
            EXPECT_EQ(judge_at(make_case(one_known_to_a_thousandth, times), 0.5, result).error, HUGE_VAL);
        }
}

TEST(conditioned, an_undefended_kernel_may_answer_anything_outside_its_domain_and_nothing_within) {
    Case c = make_case(one_known_to_a_thousandth, 4);
    for (const float result : {nan, infinity, 2000.0f}) {
        EXPECT_FALSE(judge_at(c, 2, result).pass) << "a defended one answers everything within its range";
        c.defended = false;
        EXPECT_TRUE(judge_at(c, 2, result).pass);
        EXPECT_FALSE(judge_at(c, 0.5, result).pass);
        c.defended = true;
    }
    EXPECT_TRUE(judge_at(c, 2, 999).pass) << "outside the domain only the range counts";
}

TEST(outside, a_rule_is_asked_for_where_the_input_is_in_no_domain_and_nowhere_else) {
    Case c = make_case(one_known_to_a_thousandth, 4);
    c.outside = [](std::span<const double> n) -> std::optional<Bounds> {
        if (std::isnan(n[0])) return exactly({7});
        if (n[0] > 100) return exactly({0});
        if (n[0] > 10) return Bounds{{2}, {3}};
        return {};
    };
    const auto passes = [&](double x, float result) { return judge_at(c, x, result).pass; };
    EXPECT_TRUE(passes(nan, 7));
    EXPECT_FALSE(passes(nan, 0));
    EXPECT_FALSE(passes(nan, nan));
    EXPECT_TRUE(passes(20, 2) && passes(20, 3) && passes(20, 2.5f));
    EXPECT_FALSE(passes(20, 1.99f) || passes(20, 3.01f) || passes(20, nan));
    EXPECT_TRUE(passes(200, 0.0f));
    EXPECT_FALSE(passes(200, -0.0f));
    EXPECT_TRUE(passes(2, -999)) << "where the rule says nothing only the range counts";
    EXPECT_TRUE(passes(0.5, 1));
    EXPECT_FALSE(passes(0.5, 7));

    Arguments arguments;
    const auto wanted = [&](double x) {
        arguments.numbers[0] = x;
        return format_want(c, arguments);
    };
    EXPECT_EQ(wanted(0.5), "0x1p+0");
    EXPECT_EQ(wanted(nan), "0x1.cp+2");
    EXPECT_EQ(wanted(20), "0x1p+1 to 0x1.8p+1");
    EXPECT_EQ(wanted(2), "anything from -1000 to 1000");
}

TEST(within, is_asked_for_besides_the_tolerance_where_the_input_is_in_the_domain) {
    Case c = make_case(one_known_to_a_thousandth, 4);
    c.within = [](std::span<const double> n, const Truth& truth) {
        return Bounds{{truth.value[0]}, {truth.value[0] + n[0] * 0x1p-10}}; // from above, and half as far
    };
    const auto passes = [&](double x, float result) { return judge_at(c, x, result).pass; };
    EXPECT_TRUE(passes(0.5, 1) && passes(0.5, 1 + 0x1p-11f));
    EXPECT_FALSE(passes(0.5, 1 - 0x1p-20f) || passes(0.5, 1 + 0x1p-10f));
    EXPECT_TRUE(passes(2, -999)) << "outside the domain only the range counts";
    c.tolerance = conditioned(0x1p-4);
    EXPECT_FALSE(passes(0.5, 1 + 0x1p-11f)) << "the tolerance holds too";
}

TEST(conditioned, denormal_inputs_are_outside_the_domain_of_a_reference_with_a_truth) {
    const Case c = make_case(one_known_to_a_thousandth, 4);
    Arguments arguments;
    for (const auto& [x, inside] : {std::pair{0.0, true}, std::pair{static_cast<double>(FLT_MIN), true},
                                    std::pair{static_cast<double>(FLT_TRUE_MIN), false}}) {
        arguments.numbers[0] = x;
        EXPECT_EQ(in_domain(c, arguments), inside) << x;
    }
}

TEST(conditioned, every_component_counts_in_its_own_unit) {
    const Case c = make_case<glm::dvec2(double)>(two_components, 4);
    const auto error = [&](float first, float second) {
        Arguments arguments;
        arguments.numbers[0] = 0.5;
        const std::uint32_t words[2] = {std::bit_cast<std::uint32_t>(first),
                                        std::bit_cast<std::uint32_t>(second)};
        return judge(c, arguments, words).error;
    };
    EXPECT_EQ(error(1, 2), 0);
    EXPECT_EQ(error(1 + 3 * 0x1p-10f, 2), 3);
    EXPECT_EQ(error(1, 2 + 3 * 0x1p-20f), 3);
    EXPECT_EQ(error(1 + 0x1p-10f, 2 + 2 * 0x1p-20f), 2);
    EXPECT_EQ(error(1, nan), HUGE_VAL);
}

TEST(default_samples, are_fewer_where_truths_are_slow) {
    const Case& fast = find_case("smsr/case_09");
    const Case& slow = find_case("integral/mix/radiance");
    EXPECT_LT(default_samples(slow), default_samples(fast));
    EXPECT_EQ(samples_asked_for(std::array{&fast, &slow}, {}), default_samples(fast) + default_samples(slow));
    CheckOptions options;
    options.samples = 7;
    EXPECT_EQ(samples_asked_for(std::array{&fast, &slow}, options), 14u);
}

TEST(verdicts, expected_failures_are_good_and_unexpected_passes_are_not) {
    EXPECT_TRUE(is_good(Verdict::pass));
    EXPECT_TRUE(is_good(Verdict::expected));
    for (const Verdict verdict :
         {Verdict::passes_wrongly, Verdict::wrong, Verdict::unwritten, Verdict::stray_write,
          Verdict::unstable, Verdict::compile_error, Verdict::timeout}) {
        EXPECT_FALSE(is_good(verdict)) << to_string(verdict);
        EXPECT_FALSE(to_string(verdict).empty());
    }
}

} // namespace
} // namespace gnomon
