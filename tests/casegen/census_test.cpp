#include "casegen/census.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace gnomon {
namespace {

using ::testing::ElementsAre;

const Family& smsr() { return technique_family("smsr"); }

TEST(census, shares_are_of_all_that_are_of_a_case) {
    const std::vector<Counts> censuses{{1000, 1, 3}, {5, 0, 0, 4}, {77}};
    const std::vector<CaseShare> shares = case_shares(smsr(), censuses);
    ASSERT_EQ(shares.size(), 12u);
    EXPECT_EQ(shares[0].count, 1u);
    EXPECT_DOUBLE_EQ(shares[0].share, 1.0 / 8);
    EXPECT_DOUBLE_EQ(shares[0].mean, 1.0 / 8); // of 1/4 and 0: the third census met no case
    EXPECT_DOUBLE_EQ(shares[1].mean, 3.0 / 8);
    EXPECT_DOUBLE_EQ(shares[2].mean, 0.5);
    EXPECT_DOUBLE_EQ(shares[2].deviation, std::sqrt(0.5)); // of 0 and 1
    EXPECT_EQ(shares[11].count, 0u);
    EXPECT_EQ(shares[11].share, 0);
}

TEST(census, of_nothing_has_no_shares) {
    for (const CaseShare& share : case_shares(smsr(), std::vector<Counts>{{12}})) {
        EXPECT_EQ(share.share, 0);
        EXPECT_EQ(share.mean, 0);
        EXPECT_EQ(share.deviation, 0);
    }
}

TEST(census, orders_cases_by_frequency) {
    EXPECT_THAT(cases_by_frequency(smsr(), {9, 2, 0, 7, 2}), ElementsAre(3, 1, 4));
    EXPECT_THAT(cases_by_frequency(smsr(), {9}), ElementsAre(0));
    EXPECT_THAT(held_cases(smsr(), {.cases = cases_by_frequency(smsr(), {9})}), ElementsAre());
}

TEST(census, spreads_lights_over_the_sky) {
    glm::dvec3 sum(0);
    for (unsigned i = 0; i < 200; ++i) {
        const glm::vec3 d = spread_direction(i);
        EXPECT_NEAR(glm::length(glm::dvec3(d)), 1, 1e-6);
        EXPECT_LT(d.y, -0.3f);
        for (unsigned k = 0; k < i; ++k) EXPECT_GT(glm::length(glm::dvec3(d - spread_direction(k))), 0.02);
        sum += glm::dvec3(d);
    }
    EXPECT_NEAR(sum.x / 200, 0, 0.02);
    EXPECT_NEAR(sum.z / 200, 0, 0.02);
    // The very bits: every machine's censuses are of the same lights.
    EXPECT_EQ(std::bit_cast<std::uint32_t>(spread_direction(0).x), 0x3f027f53u);
}

} // namespace
} // namespace gnomon
