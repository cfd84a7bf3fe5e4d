#include "casegen/mask.h"

#include "casegen/mask_families.h"
#include "runtime/image.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::TemporaryFolder;

std::string parse_error(const std::string& text, char separator = '\n') {
    return error_of([&] { parse_mask(text, separator, "m.txt"); });
}

TEST(mask, first_row_is_y_0_and_dots_are_lit) {
    const Mask mask = parse_mask("#..\n..#\n", '\n', "m");
    EXPECT_EQ(mask.width, 3);
    EXPECT_EQ(mask.height, 2);
    EXPECT_FALSE(mask.lit(0, 0));
    EXPECT_TRUE(mask.lit(1, 0));
    EXPECT_FALSE(mask.lit(2, 1));
    EXPECT_TRUE(mask.lit(0, 1));
}

TEST(mask, text_comes_back) {
    for (const char separator : {'\n', '/'})
        for (const NamedMask& named : mask_corpus(1, 2, 17)) {
            Mask again = parse_mask(format_mask(named.mask, separator), separator, named.name);
            again.outside = named.mask.outside;
            ASSERT_EQ(again, named.mask) << named.name;
        }
}

TEST(mask, last_line_end_is_optional_and_carriage_returns_are_blanks) {
    const Mask mask = parse_mask("#.\n.#", '\n', "m");
    EXPECT_EQ(parse_mask("#.\n.#\n", '\n', "m"), mask);
    EXPECT_EQ(parse_mask("#.\r\n.#\r\n", '\n', "m"), mask);
    EXPECT_EQ(parse_mask("#./.#", '/', "m"), mask);
}

TEST(mask, outside_answers_as_it_was_told) {
    Mask mask = parse_mask("#.\n..", '\n', "m");
    for (const auto& [x, y, nearest] : {std::tuple(-1, 0, false),
                                        {0, -1, false},
                                        {-9, -9, false},
                                        {2, 0, true},
                                        {0, 2, true},
                                        {1000000, -1000000, true}}) {
        mask.outside = Outside::clamp;
        EXPECT_EQ(mask.lit(x, y), nearest) << x << "," << y;
        mask.outside = Outside::lit;
        EXPECT_TRUE(mask.lit(x, y)) << x << "," << y;
        mask.outside = Outside::shadow;
        EXPECT_FALSE(mask.lit(x, y)) << x << "," << y;
    }
    EXPECT_TRUE(mask.lit(1, 1)); // inside, the surround has no say
}

TEST(mask, bad_text_is_named_with_row_and_column) {
    EXPECT_THAT(parse_error("##\n#\n"),
                AllOf(StartsWith("m.txt: "), HasSubstr("row 2 has 1 texels"), HasSubstr("the first has 2")));
    EXPECT_THAT(parse_error("##\n###\n"), HasSubstr("row 2 has 3"));
    EXPECT_THAT(parse_error("##\n\n##\n"), HasSubstr("row 2 has 0"));
    EXPECT_THAT(parse_error("..\n.o\n"), AllOf(StartsWith("m.txt: "), HasSubstr("row 2, column 2 is 'o'")));
    EXPECT_THAT(parse_error("..\n. \n"), HasSubstr("row 2, column 2 is ' '"));
    EXPECT_THAT(parse_error(std::string("#\0", 2)), HasSubstr("row 1, column 2 is byte 0x00"));
    EXPECT_THAT(parse_error("#\t"), HasSubstr("row 1, column 2 is byte 0x09"));
    EXPECT_THAT(parse_error("#\xe2\x96\x88"), HasSubstr("row 1, column 2 is byte 0xe2"));
    EXPECT_THAT(parse_error("##/#x", '/'), HasSubstr("row 2, column 2 is 'x'"));
}

TEST(mask, no_texels_is_an_error) {
    for (const char* text : {"", "\n", "\n\n\n", "\r\n"})
        EXPECT_THAT(parse_error(text), AllOf(StartsWith("m.txt: "), HasSubstr("no texels"))) << text;
}

TEST(mask, at_most_16384_on_a_side) {
    EXPECT_EQ(parse_mask(std::string(16384, '.'), '\n', "m").width, 16384);
    EXPECT_THAT(parse_error(std::string(16385, '.')), HasSubstr("16385 x 1"));
    std::string tall;
    for (int i = 0; i < 16385; ++i) tall += ".\n";
    EXPECT_THAT(parse_error(tall), HasSubstr("1 x 16385"));
}

TEST(mask, loads_text_and_png) {
    const TemporaryFolder folder;
    const Mask text = load_mask(folder.write("m.txt", "#.\n..\n"));
    Image image(2, 2, Rgb{255, 255, 255});
    image.at(0, 0) = Rgb{127, 127, 127}; // just darker than half
    image.at(1, 0) = Rgb{128, 128, 128};
    write_png(folder.path() / "m.png", image);
    EXPECT_EQ(load_mask(folder.path() / "m.png"), text);
}

TEST(mask, what_cannot_be_loaded_is_named) {
    const TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { load_mask(folder.path() / "none.txt"); }), HasSubstr("none.txt"));
    EXPECT_THAT(error_of([&] { load_mask(folder.write("bad.png", "\x89PNG\r\n\x1a\nnonsense")); }),
                HasSubstr("bad.png"));
    EXPECT_THAT(error_of([&] { load_mask(folder.write("bad.txt", "hello\n")); }),
                AllOf(HasSubstr("bad.txt"), HasSubstr("row 1, column 1 is 'h'")));
}

TEST(mask, transforms_move_texels_where_they_should) {
    const Mask mask = parse_mask("#..\n.#.", '\n', "m");
    EXPECT_EQ(format_mask(transposed(mask), '/'), "#./.#/..");
    EXPECT_EQ(format_mask(mirrored_x(mask), '/'), "..#/.#.");
    EXPECT_EQ(format_mask(mirrored_y(mask), '/'), ".#./#..");
}

TEST(mask, transforms_keep_the_surround_and_undo_themselves) {
    for (const NamedMask& named : mask_corpus(2, 3, 13)) {
        const Mask& mask = named.mask;
        EXPECT_EQ(transposed(transposed(mask)), mask) << named.name;
        EXPECT_EQ(mirrored_x(mirrored_x(mask)), mask) << named.name;
        EXPECT_EQ(mirrored_y(mirrored_y(mask)), mask) << named.name;
        EXPECT_EQ(transposed(mirrored_x(mask)), mirrored_y(transposed(mask))) << named.name;
    }
}

} // namespace
} // namespace gnomon
