// Counting and colouring what is wrong, on inputs made by hand.
#include "runtime/pipeline/judge.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace gnomon {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Six pixels: background, facing away, and each agreement and disagreement with the truth.
struct Six {
    Surfaces surfaces{{0, 1, 1, 1, 1, 1}, {0, 0, 1, 1, 1, 1}};
    std::array<float, 6> visibility{1, 1, 1, 0, 1, 0};
    std::array<float, 6> truth{0, 0, 1, 0, 0, 1};
};

TEST(CountPixels, CountsWhatFacesTheLightOnly) {
    const Six six;
    const PixelCounts counts = count_pixels(six.surfaces, six.visibility, six.truth);
    EXPECT_EQ(counts.all, 6u);
    EXPECT_EQ(counts.covered, 5u);
    EXPECT_EQ(counts.facing, 4u);
    EXPECT_EQ(counts.facing_away, 1u);
    EXPECT_EQ(counts.truly_lit, 2u);
    EXPECT_EQ(counts.truly_shadowed, 2u);
    EXPECT_EQ(counts.wrong_lit, 1u);
    EXPECT_EQ(counts.wrong_shadowed, 1u);
    EXPECT_EQ(counts.wrong_share(), 0.5);
}

TEST(CountPixels, NothingFacingIsNothingWrong) {
    const Surfaces surfaces{{0, 1}, {0, 0}};
    const std::array<float, 2> visibility{1, 1}, truth{0, 0};
    const PixelCounts counts = count_pixels(surfaces, visibility, truth);
    EXPECT_EQ(counts.facing, 0u);
    EXPECT_EQ(counts.wrong_lit + counts.wrong_shadowed, 0u);
    EXPECT_EQ(counts.wrong_share(), 0);
    EXPECT_EQ(count_pixels({}, {}, {}).wrong_share(), 0);
}

TEST(CountPixels, NanIsShadowAndNeverLit) {
    const Surfaces surfaces{{1, 1}, {1, 1}};
    const std::array<float, 2> visibility{nan, nan}, truth{1, 0};
    const PixelCounts counts = count_pixels(surfaces, visibility, truth);
    EXPECT_EQ(counts.wrong_shadowed, 1u);
    EXPECT_EQ(counts.wrong_lit, 0u);
    const PixelCounts by_nan = count_pixels(surfaces, truth, visibility); // and a truth that is NaN
    EXPECT_EQ(by_nan.truly_shadowed, 2u);
    EXPECT_EQ(by_nan.wrong_lit, 1u);
}

TEST(CountPixels, AHalfIsLit) {
    const Surfaces surfaces{{1, 1}, {1, 1}};
    const std::array<float, 2> visibility{0.5f, std::nextafter(0.5f, 0.0f)}, truth{1, 1};
    EXPECT_EQ(count_pixels(surfaces, visibility, truth).wrong_shadowed, 1u);
}

TEST(FalseColours, EveryVerdictHasItsColour) {
    const Six six;
    const Image image = false_colours(six.surfaces, six.visibility, six.truth, 3, 2);
    ASSERT_EQ(image.width, 3);
    ASSERT_EQ(image.height, 2);
    const Rgb background{255, 255, 255}, away{92, 104, 120}, lit{208, 208, 208}, shadow{72, 72, 72};
    const Rgb wrong_lit{230, 30, 30}, wrong_shadowed{30, 90, 240};
    EXPECT_EQ(image.pixels, (std::vector<Rgb>{background, away, lit, shadow, wrong_lit, wrong_shadowed}));
}

TEST(FalseColours, NanIsShadow) {
    const Surfaces surfaces{{1, 1}, {1, 1}};
    const std::array<float, 2> visibility{nan, nan}, truth{1, 0};
    const Image image = false_colours(surfaces, visibility, truth, 2, 1);
    EXPECT_EQ(image.at(0, 0), (Rgb{30, 90, 240}));
    EXPECT_EQ(image.at(1, 0), (Rgb{72, 72, 72}));
}

} // namespace
} // namespace gnomon
