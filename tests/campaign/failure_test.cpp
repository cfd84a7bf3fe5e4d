#include "casegen/fuzz/failure.h"

#include "casegen/catalogue.h"
#include "tests/support/text.h"

#include <gtest/gtest.h>

#include <limits>

namespace gnomon::fuzz {
namespace {

using testing::bits;

std::string failure(const std::string& kernel, const std::vector<std::uint32_t>& words, float result,
                    const Mask* mask = nullptr) {
    const Case& c = find_case(kernel);
    const Arguments with = arguments(c, words, mask);
    const std::vector<std::uint32_t> got{bits(result)};
    return failure_of(c, with, got, judge(c, with, got));
}

TEST(failure, tells_apart_what_an_author_would) {
    const std::vector<std::uint32_t> inside{bits(0.5f), bits(0.5f), bits(0.25f)};
    EXPECT_EQ(failure("smsr/case_09", inside, 1), "");
    EXPECT_EQ(failure("smsr/case_09", inside, 0), "wrong");
    EXPECT_EQ(failure("smsr/case_09", inside, 2), "out of range");
    EXPECT_EQ(failure("smsr/case_09", inside, std::numeric_limits<float>::quiet_NaN()), "NaN");
    const std::vector<std::uint32_t> outside{bits(7), bits(0.5f), bits(0.25f)};
    EXPECT_EQ(failure("smsr/case_09", outside, 0), "");
    EXPECT_EQ(failure("smsr/case_09", outside, -1), "out of range, outside the domain");
    EXPECT_EQ(failure("smsr/case_09", outside, std::numeric_limits<float>::quiet_NaN()),
              "NaN, outside the domain");
}

TEST(failure, names_the_texel_s_case_where_a_mask_decides) {
    // Lit, shadow towards +y only, and that run goes on to one side: case 9.
    const Mask mask = parse_mask("..#/.##", '/', "mask");
    const std::vector<std::uint32_t> words{1, 0, bits(0.9f), bits(0.9f)};
    const Case& c = find_case("smsr/visibility");
    const Numbers want = c.reference.call(arguments(c, words, &mask));
    const unsigned number = number_by_conditions(technique_family("smsr"), reference::edge(mask, {1, 0}));
    ASSERT_GT(number, 0u);
    EXPECT_EQ(failure("smsr/visibility", words, want[0] == 0 ? 1.0f : 0.0f, &mask),
              "wrong in case " + std::to_string(number));
    EXPECT_EQ(failure("smsr/visibility", words, static_cast<float>(want[0]), &mask), "");
}

} // namespace
} // namespace gnomon::fuzz
