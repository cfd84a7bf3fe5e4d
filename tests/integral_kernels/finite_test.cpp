// Kernels that are defended answer every bit pattern, with a number of their result's range; and what no
// caller should ask as their table's rule says.
#include "casegen/check.h"
#include "tests/integral_kernels/rows.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using testing::Row;
using testing::run_rows;

constexpr std::size_t patterns = 100'000;

bool is_finite_pattern(std::uint32_t bits) { return (bits & 0x7f800000u) != 0x7f800000u; }

/// Any finite float, whatever its size.
std::uint32_t finite_bits(Random& random) {
    for (;;) {
        const auto bits = static_cast<std::uint32_t>(random.bits());
        if (is_finite_pattern(bits)) return bits;
    }
}
/// Infinity or NaN of any payload.
std::uint32_t other_bits(Random& random) {
    const auto bits = static_cast<std::uint32_t>(random.bits());
    return random.chance(0.4) ? (bits & 0x80000000u) | 0x7f800000u : bits | 0x7f800000u;
}

/// Rows of bit patterns: all of them finite, or at least one of each row that is not. Every other row is what
/// the generator draws, with some of its numbers replaced.
std::vector<Row> rows_of_patterns(const Case& c, bool finite) {
    std::vector<Row> rows;
    rows.reserve(patterns);
    std::vector<std::uint32_t> words(word_count(c));
    const auto count = static_cast<std::uint32_t>(words.size());
    for (std::size_t i = 0; i < patterns; ++i) {
        Random random(hash(c.name) + (finite ? 0 : 1), i);
        if (c.generator && i % 2 == 0)
            draw_generated(c, random, {}, words);
        else
            for (std::uint32_t& word : words) word = finite_bits(random);
        words[random.below(count)] = finite ? finite_bits(random) : other_bits(random);
        if (random.chance(0.3))
            words[random.below(count)] = finite ? finite_bits(random) : other_bits(random);
        rows.push_back(testing::as_floats(words));
    }
    return rows;
}

void expect_in_range(const Case& c, const std::vector<Row>& rows, const std::vector<float>& results) {
    const std::size_t components = results.size() / rows.size();
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto value = static_cast<double>(results[i]);
        if (value >= c.result.lower && value <= c.result.upper && std::isfinite(value)) continue;
        std::vector<std::uint32_t> words;
        for (const float x : rows[i / components]) words.push_back(std::bit_cast<std::uint32_t>(x));
        FAIL() << fmt::format("{} gives {} instead of {} … {}", format_call(c, words, nullptr), value,
                              c.result.lower, c.result.upper);
    }
}

class defended : public ::testing::TestWithParam<const Case*> {};

TEST_P(defended, answers_any_finite_numbers_within_its_range) {
    const Case& c = *GetParam();
    const std::vector<Row> rows = rows_of_patterns(c, true);
    expect_in_range(c, rows, run_rows(c.name, rows));
}

TEST_P(defended, answers_what_is_no_number_as_its_rule_says) {
    const Case& c = *GetParam();
    const std::vector<Row> rows = rows_of_patterns(c, false);
    const std::vector<float> results = run_rows(c.name, rows);
    expect_in_range(c, rows, results);
    std::vector<float> answer;
    if (c.rule.ends_with("not finite gives 0")) answer.assign(results.size() / rows.size(), 0.0f);
    if (c.rule.ends_with("not finite gives (-1, 1)")) answer = {-1, 1};
    if (c.rule.ends_with("not finite gives (2, 0)")) answer = {2, 0};
    if (answer.empty()) {
        EXPECT_THAT(c.rule, Not(HasSubstr("finite"))) << c.name << ": a rule that this test does not know";
        return;
    }
    for (std::size_t i = 0; i < results.size(); ++i)
        ASSERT_TRUE(testing::same_bits(results[i], answer[i % answer.size()]))
            << c.name << " row " << i / answer.size() << " gives " << results[i];
}

INSTANTIATE_TEST_SUITE_P(kernels, defended, ::testing::ValuesIn(testing::defended_kernels()),
                         [](const auto& instance) { return function_name(*instance.param); });

TEST(rules, every_defended_kernel_but_the_elementary_ones_has_one) {
    for (const Case* c : testing::defended_kernels())
        if (!c->name.starts_with("integral/elementary/"))
            EXPECT_THAT(c->rule, HasSubstr("not finite gives")) << c->name;
    for (const Case* c : find_cases("integral/*"))
        if (!c->defended)
            EXPECT_THAT(c->rule, AnyOf(HasSubstr("as printed"), HasSubstr("whatever comes of it")))
                << c->name;
}

} // namespace
} // namespace gnomon
