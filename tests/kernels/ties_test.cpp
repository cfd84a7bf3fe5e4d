// On the border of light and shadow, where tolerances let either pass: at inputs whose every intermediate
// result is exact, a kernel must give what the definition says to the last bit. A point on the straightened
// edge is lit, and so is a receiver at its occluder's depth. docs/revectorization.md 2.2, A11
#include "casegen/catalogue.h"
#include "tests/support/device.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>

namespace gnomon {
namespace {

constexpr int steps = 8;

/// All combinations of multiples of 1/8 for floats, and of the domain's values for the rest.
Records exact_inputs(const Case& c) {
    std::vector<std::vector<std::uint32_t>> values;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Type type = c.reference.parameters[i];
        const Domain& domain = c.parameters[i].domain;
        for (std::size_t k = 0; k < static_cast<std::size_t>(type.components); ++k) {
            std::vector<std::uint32_t>& of_component = values.emplace_back();
            for (const std::vector<double>& choice : domain.choices)
                of_component.push_back(narrow(type.scalar, choice[k]));
            for (int n = 0; domain.choices.empty() && n <= steps; ++n)
                of_component.push_back(
                    narrow(type.scalar, domain.lower + (domain.upper - domain.lower) * n / steps));
        }
    }
    Records records(c);
    std::vector<std::size_t> at(values.size(), 0);
    for (std::size_t digit = 0; digit < at.size();) {
        std::vector<std::uint32_t> words;
        for (std::size_t i = 0; i < at.size(); ++i) words.push_back(values[i][at[i]]);
        records.add(words, nullptr);
        for (digit = 0; digit < at.size() && ++at[digit] == values[digit].size(); ++digit) at[digit] = 0;
    }
    return records;
}

class ties : public ::testing::TestWithParam<std::string> {};

TEST_P(ties, are_decided_as_defined) {
    const Case& c = find_case(GetParam());
    const Records records = exact_inputs(c);
    const std::vector<std::uint32_t> results = testing::run_kernel(c.name, records);
    const Scalar scalar = c.reference.result.scalar;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Numbers want = c.reference.call(arguments(c, records.input(i), nullptr));
        ASSERT_EQ(results[i], narrow(scalar, want[0])) << c.name << " input " << i;
    }
}

std::vector<std::string> kernels_with_ties() {
    std::vector<std::string> names{"revectorize/shadow_test"};
    for (int number = 4; number <= 12; ++number) names.push_back(fmt::format("smsr/case_{:02}", number));
    return names;
}

INSTANTIATE_TEST_SUITE_P(kernels, ties, ::testing::ValuesIn(kernels_with_ties()),
                         [](const auto& instance) { return function_name(find_case(instance.param)); });

std::uint32_t at(const std::string& kernel, const std::vector<float>& input) {
    Records records(find_case(kernel));
    std::vector<std::uint32_t> words;
    for (const float value : input) words.push_back(std::bit_cast<std::uint32_t>(value));
    records.add(words, nullptr);
    return testing::run_kernel(kernel, records).at(0);
}

// By hand, so that reference and kernel cannot both be wrong.
TEST(ties_by_hand, the_line_itself_is_lit) {
    const std::uint32_t lit = std::bit_cast<std::uint32_t>(1.0f), dark = 0;
    EXPECT_EQ(at("smsr/case_09", {0.5f, 0.25f, 0.75f}), lit);
    EXPECT_EQ(at("smsr/case_09", {0.5f, 0.375f, 0.75f}), dark);
    EXPECT_EQ(at("smsr/case_10", {0.5f, 0.75f, 0.75f}), lit);
    EXPECT_EQ(at("smsr/case_10", {0.5f, 0.625f, 0.75f}), dark);
    EXPECT_EQ(at("smsr/case_11", {0.75f, 0.5f, 0.75f}), lit);
    EXPECT_EQ(at("smsr/case_11", {0.625f, 0.5f, 0.75f}), dark);
    EXPECT_EQ(at("smsr/case_12", {0.25f, 0.5f, 0.75f}), lit);
    EXPECT_EQ(at("smsr/case_12", {0.375f, 0.5f, 0.75f}), dark);
    EXPECT_EQ(at("smsr/case_06", {0.5f, 0.25f, 0.75f}), lit);
    EXPECT_EQ(at("smsr/case_07", {0.5f, 0.75f, 0.75f}), lit);
    EXPECT_EQ(at("revectorize/shadow_test", {0.5f, 0.0f, 0.5f}), 1u);
    EXPECT_EQ(at("revectorize/shadow_test", {0.5f, 0.0625f, 0.4375f}), 1u);
    EXPECT_EQ(at("revectorize/shadow_test", {0.5f, 0.0f, 0.4375f}), 0u);
}

} // namespace
} // namespace gnomon
