// What transposition, mirror images and the exchange of light and shadow do to RSMSS and to the five shapes,
// for every reading of the document. docs/revectorization.md 4.4
#include "casegen/reference/rbsm.h"
#include "casegen/reference/rsmss.h"
#include "casegen/symmetry.h"

#include "tests/support/case_chain.h"
#include "tests/support/masks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::ivec2;

/// Readings that choose by the order of a list are not symmetric, and cannot be.
constexpr unsigned symmetric_options = reference::printed_end | reference::opposite_breach |
                                       reference::ramped_bar | reference::long_runs |
                                       reference::breach_by_position;

class rsmss_symmetry : public ::testing::TestWithParam<Symmetry> {
protected:
    void compare(const Mask& mask, Random& random) {
        const Symmetry& turn = GetParam();
        const Mask image = turn.of_mask(mask);
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x) {
                const ivec2 texel(x, y), there = turn.of_texel(mask, texel);
                const reference::Edge here = reference::edge(mask, texel),
                                      turned = reference::edge(image, there);
                if (here.sides == glm::uvec2(0)) continue;
                const Case *c = cases_.case_of(here), *c_turned = cases_.case_of(turned);
                const unsigned number = c ? c->number : 0;
                ASSERT_EQ(c_turned ? c_turned->number : 0, turn.of_rsmss_number(number))
                    << format_mask(mask, '\n');
                ++met_[number];
                const unsigned options = random.below(128) & symmetric_options;
                const dvec2 p(random.below(256) / 256.0, 0.37109375); // exact in both
                const dvec2 q = turn.of_point(p);
                ASSERT_NEAR(cases_.value(mask, texel, here, p, options),
                            cases_.value(image, there, turned, q, options), 1e-12)
                    << "case " << number << ", options " << options << "\n"
                    << format_mask(mask, '\n');
                ASSERT_NEAR(reference::rbsm_filter(here, p), reference::rbsm_filter(turned, q), 1e-12);
                if (here.lit) ASSERT_EQ(silhouette(here, p), silhouette(turned, q));
            }
    }
    /// Off the line, where rounding does not decide.
    static double silhouette(const reference::Edge& edge, dvec2 p) {
        return reference::rbsm_silhouette(edge, p + dvec2(1e-9 * (p.x - 0.5), 1e-9 * (p.y - 0.5)));
    }
    const testing::CaseChain cases_{"rsmss"};
    std::map<unsigned, int> met_;
};

TEST_P(rsmss_symmetry, holds_on_masks_of_all_families) {
    Random random(31);
    for (const NamedMask& named : mask_corpus(31, 4, 32)) {
        SCOPED_TRACE(named.name);
        compare(named.mask, random);
        ASSERT_FALSE(HasFatalFailure());
    }
    for (unsigned number = 0; number <= 31; ++number) EXPECT_GT(met_[number], 0) << "case " << number;
}

TEST_P(rsmss_symmetry, holds_on_4x4_masks) {
    Random random(32);
    for (const Outside outside : {Outside::lit, Outside::shadow})
        for (std::uint32_t bits = 0; bits < 1u << 16; bits += 11) { // 11 divides no period
            compare(testing::mask_of_bits(bits, 4, outside), random);
            ASSERT_FALSE(HasFatalFailure());
        }
}

INSTANTIATE_TEST_SUITE_P(of_the_square, rsmss_symmetry, ::testing::ValuesIn(symmetries),
                         [](const auto& instance) { return std::string(instance.param.name); });

// Light and shadow exchanged: what one gains the other loses, except where the document means it otherwise:
// slots and bars between two ends (4 to 7 against 12 to 15), and a bar's end with a far breach unless A8 is
// read by position.
TEST(rsmss_complement, holds_where_the_document_has_it) {
    const testing::CaseChain cases("rsmss");
    const std::set<unsigned> different{4, 5, 6, 7};
    std::map<unsigned, int> met, broken, broken_by_position;
    for (const NamedMask& named : mask_corpus(33, 10, 32)) {
        Mask inverse = named.mask;
        for (std::uint8_t& texel : inverse.texels) texel = texel ? 0 : 1;
        if (inverse.outside != Outside::clamp)
            inverse.outside = inverse.outside == Outside::lit ? Outside::shadow : Outside::lit;
        for (int y = 0; y < named.mask.height; ++y)
            for (int x = 0; x < named.mask.width; ++x) {
                const reference::Edge here = reference::edge(named.mask, {x, y}),
                                      there = reference::edge(inverse, {x, y});
                const Case* c = cases.case_of(here);
                if (!here.lit || !c) continue;
                for (const dvec2 p : {dvec2(0.1237, 0.3391), dvec2(0.7713, 0.0911), dvec2(0.4, 0.9)}) {
                    ++met[c->number];
                    for (const unsigned options :
                         {0u, static_cast<unsigned>(reference::breach_by_position)}) {
                        const double sum = cases.value(named.mask, {x, y}, here, p, options) +
                                           cases.value(inverse, {x, y}, there, p, options);
                        if (std::abs(sum - 1) > 1e-12)
                            ++(options == 0 ? broken : broken_by_position)[c->number];
                    }
                    ASSERT_NEAR(reference::rbsm_filter(here, p) + reference::rbsm_filter(there, p), 1, 1e-12);
                }
            }
    }
    for (const unsigned number : {1u, 2u, 8u, 9u, 10u, 11u, 16u, 17u, 18u, 19u, 20u, 21u, 22u, 23u}) {
        EXPECT_GT(met[number], 0) << number;
        EXPECT_EQ(broken_by_position[number], 0) << "case " << number;
        if (number != 8 && number != 10) EXPECT_EQ(broken[number], 0) << "case " << number;
    }
    for (const unsigned number : {8u, 10u}) {
        const double share = 100.0 * broken[number] / met[number];
        fmt::print("complement of case {}: {:.1f} % of samples differ by the far breach\n", number, share);
        EXPECT_GT(broken[number], 0);
        EXPECT_LT(share, 15); // of masks with more slots than a scene has
    }
    for (const unsigned number : different) EXPECT_GT(broken[number], 0) << "case " << number;
}

} // namespace
} // namespace gnomon
