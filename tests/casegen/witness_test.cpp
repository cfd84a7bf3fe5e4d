#include "casegen/witness.h"

#include "casegen/catalogue.h"
#include "runtime/files.h"
#include "tests/support/environment.h"
#include "tests/support/smsr_chain.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace gnomon {
namespace {

using testing::smsr_case_of;

class witness : public ::testing::TestWithParam<unsigned> {
protected:
    const Case& kernel() const { return find_case(fmt::format("smsr/case_{:02}", GetParam())); }
};

TEST_P(witness, is_found_within_3_by_3_texels) {
    const auto found = smallest_witness(kernel());
    ASSERT_TRUE(found);
    EXPECT_LE(found->mask.width, 3);
    EXPECT_LE(found->mask.height, 3);
    EXPECT_TRUE(found->mask.lit(found->texel.x, found->texel.y));
    EXPECT_EQ(smsr_case_of(reference::edge(found->mask, found->texel)), &kernel());
}

TEST_P(witness, nothing_smaller_is_one) {
    const auto found = smallest_witness(kernel());
    ASSERT_TRUE(found);
    EXPECT_FALSE(smallest_witness(kernel(), found->mask.width * found->mask.height - 1));
}

INSTANTIATE_TEST_SUITE_P(smsr, witness, ::testing::Range(1u, 13u));

TEST(witness_search, gives_up) {
    Case never = find_case("smsr/case_01");
    never.condition = {{.light = 0}};
    EXPECT_FALSE(smallest_witness(never, 6));
}

// Drawn by hand from the supplement's pictures, not by the search.
TEST(witness_masks, lead_to_their_cases) {
    std::istringstream lines(read_file(testing::fixtures_folder() / "witnesses/smsr.txt"));
    std::map<unsigned, int> seen;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with("//")) continue;
        std::istringstream words(line);
        unsigned number = 0;
        std::string surround, picture;
        ASSERT_TRUE(words >> number >> surround >> picture) << line;
        const std::size_t at = picture.find('o');
        ASSERT_NE(at, picture.npos) << line;
        picture[at] = '.';
        Mask mask = parse_mask(picture, '/', line);
        mask.outside = surround == "lit" ? Outside::lit : Outside::shadow;
        const int stride = mask.width + 1, index = static_cast<int>(at);
        const Case* c = smsr_case_of(reference::edge(mask, {index % stride, index / stride}));
        ASSERT_NE(c, nullptr) << line;
        EXPECT_EQ(c->number, number) << line;
        ++seen[number];
    }
    for (unsigned number = 1; number <= 12; ++number) EXPECT_GE(seen[number], 1) << "case " << number;
}

} // namespace
} // namespace gnomon
