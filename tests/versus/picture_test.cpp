// Axes as people write them, and the colours of results that are made up.
#include "casegen/versus/picture.h"

#include "casegen/catalogue.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon::versus {
namespace {

using testing::bits;
using testing::error_of;
using ::testing::HasSubstr;

TEST(axes, are_those_that_tell_most_unless_one_says) {
    const Case& c = find_case("smsr/case_09");
    std::array<Axis, 2> axes = telling_axes(c, {});
    EXPECT_EQ(axes[0].name, "p.x");
    EXPECT_EQ(axes[1].name, "p.y");
    EXPECT_EQ(axes[1].to, 1);
    std::vector<Whereabouts> where(3);
    const char* names[] = {"p.x", "p.y", "along_x"};
    for (std::size_t i = 0; i < 3; ++i) {
        where[i].name = names[i];
        where[i].inside = 100 - 10 * i;
    }
    axes = telling_axes(c, where);
    EXPECT_EQ(axes[0].name, "p.y");
    EXPECT_EQ(axes[1].name, "along_x");
    axes = parse_axes(c, "along_x=0.25:0.5,p.y");
    EXPECT_EQ(axes[0].word, 2u);
    EXPECT_EQ(axes[0].from, 0.25);
    EXPECT_EQ(axes[0].to, 0.5);
    EXPECT_EQ(axes[1].word, 1u);
    axes = telling_axes(find_case("smsr/visibility"), {}); // ivec2 texel, vec2 p
    EXPECT_EQ(axes[0].name, "p.x");
}

TEST(axes, take_whole_numbers_in_bands) {
    const std::array<Axis, 2> axes = parse_axes(find_case("smsr/visibility"), "texel.x=0:3,texel.y=-1:1.5");
    EXPECT_THAT(axes[0].values, ::testing::ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(axes[1].values, ::testing::ElementsAre(-1, 0, 1));
}

TEST(axes, refuse_what_is_none) {
    const Case& c = find_case("smsr/case_09");
    const auto refused = [&](const std::string& text) { return error_of([&] { parse_axes(c, text); }); };
    EXPECT_THAT(refused("p.z,p.x"), HasSubstr("it has p.x, p.y, along_x"));
    EXPECT_THAT(refused("p.x"), HasSubstr("two inputs"));
    EXPECT_THAT(refused("p.x,p.y,along_x"), HasSubstr("two inputs"));
    EXPECT_THAT(refused("p.x,p.x"), HasSubstr("two different"));
    EXPECT_THAT(refused("p.x=1:0,p.y"), HasSubstr("empty"));
    EXPECT_THAT(refused("p.x=a:1,p.y"), HasSubstr("\"a\" is no number"));
    EXPECT_THAT(refused("p.x=0,p.y"), HasSubstr("is no number"));
    EXPECT_THAT(refused("p.x=0:inf,p.y"), HasSubstr("is no number"));
    EXPECT_THAT(error_of([] { parse_axes(find_case("smsr/visibility"), "texel.x=0.2:0.8,p.x"); }),
                HasSubstr("no whole number"));
}

TEST(picture, varies_two_inputs_and_leaves_the_others) {
    const Case& c = find_case("smsr/case_09");
    const std::array<Axis, 2> axes = parse_axes(c, "along_x,p.x");
    const CsvInput rest{{bits(9.f), bits(0.125f), bits(9.f)}, {}};
    const Records records = picture_records(c, axes, {4, 2}, rest);
    ASSERT_EQ(records.size(), 8u);
    EXPECT_THAT(records.input(0), ::testing::ElementsAre(bits(0.25f), bits(0.125f), bits(0.125f)));
    EXPECT_THAT(records.input(3), ::testing::ElementsAre(bits(0.25f), bits(0.125f), bits(0.875f)));
    EXPECT_THAT(records.input(4), ::testing::ElementsAre(bits(0.75f), bits(0.125f), bits(0.125f)));
}

TEST(picture, has_a_colour_for_every_kind_of_difference) {
    const Case& c = find_case("smsr/case_09");
    const std::array<Axis, 2> axes = parse_axes(c, "p.x=-1:1,p.y=0:1");
    const Records records =
        picture_records(c, axes, {8, 1}, {{bits(0.f), bits(0.f), bits(0.5f)}, {}}); // 4 to 7: in the domain
    const std::uint32_t one = bits(1.f), nan = 0x7fc00000u;
    const std::vector<std::uint32_t> a{one, nan, one, one, one, one, one, one},
        b{one, nan, nan, bits(2.f), bits(0.f), bits(1.5f), bits(1.f) + 1, one};
    const Picture picture = picture_of(c, records, {8, 1}, a, b);
    EXPECT_EQ(picture.scale, 1);
    EXPECT_EQ(picture.differ, 5u);
    EXPECT_EQ(picture.finiteness, 1u);
    EXPECT_EQ(picture.both_nan, 1u);
    EXPECT_EQ(picture.outside, 4u);
    const std::vector<Rgb>& pixels = picture.image.pixels;
    EXPECT_EQ(pixels[0], outside_colour);
    EXPECT_EQ(pixels[1], both_nan_colour);
    EXPECT_EQ(pixels[2], not_finite_colour);
    EXPECT_EQ(pixels[3], larger_colour);
    EXPECT_EQ(pixels[4], smaller_colour);
    EXPECT_NE(pixels[5], larger_colour);
    EXPECT_NE(pixels[6], same_colour) << "no difference is too small to be seen";
    EXPECT_LT(pixels[5].b, pixels[6].b) << "the larger, the stronger";
    EXPECT_EQ(pixels[7], same_colour);
}

} // namespace
} // namespace gnomon::versus
