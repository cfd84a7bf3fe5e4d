// What a mask's transposition and mirror images do to case and value. docs/revectorization.md 1 and 2.2
#include "casegen/reference/mask_space.h"
#include "casegen/symmetry.h"

#include "tests/support/masks.h"
#include "tests/support/smsr_chain.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

class symmetry : public ::testing::TestWithParam<Symmetry> {
protected:
    /// Compares case and value of every lit texel with those of its image.
    void compare(const Mask& mask) {
        const Symmetry& turn = GetParam();
        const Mask image = turn.of_mask(mask);
        testing::for_lit_texels(mask, [&](glm::ivec2 texel) {
            const reference::Edge edge = reference::edge(mask, texel);
            const reference::Edge turned = reference::edge(image, turn.of_texel(mask, texel));
            const Case *c = testing::smsr_case_of(edge), *c_turned = testing::smsr_case_of(turned);
            const unsigned number = c ? c->number : 0, number_turned = c_turned ? c_turned->number : 0;
            ASSERT_EQ(number_turned, turn.of_number(number, edge.sides)) << format_mask(mask, '\n');
            ++compared_[number];
            // Not on the line where light and shadow meet: there rounding decides.
            for (const glm::dvec2 p : {glm::dvec2(0.1237, 0.3391), glm::dvec2(0.7713, 0.0911)}) {
                const glm::dvec2 q = turn.of_point(p);
                ASSERT_EQ(testing::smsr_by_cases(edge, p), testing::smsr_by_cases(turned, q))
                    << format_mask(mask, '\n');
                ASSERT_EQ(reference::smsr_visibility_in_mask_space(mask, texel, p),
                          reference::smsr_visibility_in_mask_space(image, turn.of_texel(mask, texel), q))
                    << format_mask(mask, '\n');
            }
        });
    }
    std::array<std::size_t, 13> compared_{};
};

TEST_P(symmetry, holds_on_masks_of_all_families) {
    for (const NamedMask& named : mask_corpus(31, 4, 32)) {
        SCOPED_TRACE(named.name);
        compare(named.mask);
        ASSERT_FALSE(HasFatalFailure());
    }
    for (std::size_t number = 0; number < compared_.size(); ++number)
        EXPECT_GT(compared_[number], 0u) << "case " << number << " was never met";
}

TEST_P(symmetry, holds_on_4x4_masks) {
    for (const Outside outside : {Outside::lit, Outside::shadow})
        for (std::uint32_t bits = 0; bits < 1u << 16; bits += 7) { // a seventh of them: 7 divides no period
            compare(testing::mask_of_bits(bits, 4, outside));
            ASSERT_FALSE(HasFatalFailure());
        }
}

INSTANTIATE_TEST_SUITE_P(of_the_square, symmetry, ::testing::ValuesIn(symmetries),
                         [](const auto& instance) { return std::string(instance.param.name); });

} // namespace
} // namespace gnomon
