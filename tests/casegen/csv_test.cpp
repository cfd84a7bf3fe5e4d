#include "casegen/csv.h"

#include "casegen/catalogue.h"
#include "casegen/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

using testing::bits;
using ::testing::ElementsAre;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::TemporaryFolder;

std::uint32_t word(Scalar scalar, const std::string& cell) { return parse_word(scalar, cell, "here"); }
std::string word_error(Scalar scalar, const std::string& cell) {
    return error_of([&] { parse_word(scalar, cell, "f.csv: row 3, column p_x"); });
}
std::string csv_error(const std::string& text) {
    return error_of([&] { parse_csv(text, "f.csv"); });
}
std::string input_error(const std::string& kernel, const std::string& text) {
    return error_of([&] { read_inputs(find_case(kernel), parse_csv(text, "f.csv")); });
}

TEST(csv, header_and_rows) {
    const Csv csv = parse_csv("a, b\n1,2\n 3 ,\t4\n", "f");
    EXPECT_THAT(csv.header, ElementsAre("a", "b"));
    ASSERT_EQ(csv.rows.size(), 2u);
    EXPECT_THAT(csv.rows[1], ElementsAre("3", "4"));
    EXPECT_EQ(csv.column("b"), 1u);
    EXPECT_EQ(csv.place(1, 0), "f: row 2, column a");
}

TEST(csv, byte_order_marks_carriage_returns_blank_lines_and_leading_comments_are_left_out) {
    const Csv csv = parse_csv("\xef\xbb\xbf# a comment\n\na,b\r\n\r\n1,2", "f");
    EXPECT_THAT(csv.header, ElementsAre("a", "b"));
    ASSERT_EQ(csv.rows.size(), 1u);
    EXPECT_THAT(csv.rows[0], ElementsAre("1", "2"));
}

TEST(csv, a_number_ends_where_its_cell_does) {
    using namespace std::string_literals;
    for (const std::string& cell : {"1\0"s, "1\0 2"s, "\0"s})
        for (const Scalar scalar : {Scalar::float32, Scalar::int32})
            EXPECT_THROW(parse_word(scalar, cell, "here"), Error);
}

TEST(csv, malformed_files_are_named) {
    EXPECT_THAT(csv_error(""), AllOf(StartsWith("f.csv: "), HasSubstr("empty")));
    EXPECT_THAT(csv_error("\n# only this\n"), HasSubstr("empty"));
    EXPECT_THAT(csv_error("a,b\n"), AllOf(StartsWith("f.csv: "), HasSubstr("no rows")));
    EXPECT_THAT(csv_error("a,,c\n1,2,3\n"), HasSubstr("column 2 has no name"));
    EXPECT_THAT(csv_error("a,b,a\n1,2,3\n"), HasSubstr("\"a\""));
    EXPECT_THAT(csv_error("a,b\n1,2\n1,2,3\n"), AllOf(HasSubstr("line 3 has 3 cells"), HasSubstr("has 2")));
    EXPECT_THAT(csv_error("a,b\n1\n"), HasSubstr("line 2 has 1 cells"));
}

TEST(csv, missing_column_lists_what_there_is) {
    EXPECT_THAT(error_of([] { static_cast<void>(parse_csv("a,b\n1,2\n", "f.csv").column("c")); }),
                AllOf(StartsWith("f.csv: "), HasSubstr("\"c\""), HasSubstr("a, b")));
}

TEST(csv, missing_file_is_named) {
    EXPECT_THAT(error_of([] { read_csv("/nowhere/in.csv"); }), HasSubstr("/nowhere/in.csv"));
}

TEST(csv, every_float_comes_back_bit_by_bit) {
    const auto comes_back = [](std::uint32_t pattern) {
        return word(Scalar::float32, format_word(Scalar::float32, pattern)) == pattern;
    };
    for (const float value :
         {0.0f, -0.0f, 1.0f, 0.1f, -1.0f / 3, std::numeric_limits<float>::denorm_min(),
          -std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::min(),
          std::nextafter(std::numeric_limits<float>::min(), 0.0f), std::numeric_limits<float>::max(),
          std::numeric_limits<float>::lowest(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity()})
        EXPECT_TRUE(comes_back(bits(value))) << value;
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const auto pattern = static_cast<std::uint32_t>(random.bits());
        if (std::isnan(std::bit_cast<float>(pattern))) continue;
        ASSERT_TRUE(comes_back(pattern)) << std::hex << pattern;
    }
    EXPECT_TRUE(std::isnan(std::bit_cast<float>(
        word(Scalar::float32, format_word(Scalar::float32, bits(std::numeric_limits<float>::quiet_NaN()))))));
}

TEST(csv, floats_are_read_as_written) {
    EXPECT_EQ(word(Scalar::float32, "0x1.8p-1"), bits(0.75f));
    EXPECT_EQ(word(Scalar::float32, "-0"), bits(-0.0f));
    EXPECT_EQ(word(Scalar::float32, "1e-45"), 1u);
    EXPECT_EQ(word(Scalar::float32, "-inf"), bits(-std::numeric_limits<float>::infinity()));
    EXPECT_EQ(word(Scalar::float32, ".1"), bits(0.1f));
    EXPECT_EQ(format_word(Scalar::float32, bits(0.75f)), "0x1.8p-1");
    EXPECT_EQ(format_word(Scalar::float32, bits(-0.0f)), "-0x0p+0");
}

TEST(csv, whole_numbers_come_back) {
    for (const std::int32_t value :
         {0, 1, -1, 17, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}) {
        const auto pattern = std::bit_cast<std::uint32_t>(value);
        EXPECT_EQ(word(Scalar::int32, format_word(Scalar::int32, pattern)), pattern);
    }
    for (const std::uint32_t pattern : {0u, 1u, 0x80000000u, 0xffffffffu})
        EXPECT_EQ(word(Scalar::uint32, format_word(Scalar::uint32, pattern)), pattern);
    EXPECT_EQ(word(Scalar::boolean, "1"), 1u);
    EXPECT_EQ(word(Scalar::boolean, "0"), 0u);
}

TEST(csv, text_in_numbers_is_named_with_its_place) {
    for (const Scalar scalar : {Scalar::float32, Scalar::int32, Scalar::uint32, Scalar::boolean})
        for (const char* cell : {"abc", "", "1x", "0x", "1 2", "--1", "1,5"})
            EXPECT_THAT(word_error(scalar, cell), StartsWith("f.csv: row 3, column p_x is ")) << cell;
}

TEST(csv, numbers_that_do_not_fit_are_refused) {
    EXPECT_THAT(word_error(Scalar::float32, "1e39"), HasSubstr("float can hold"));
    EXPECT_THAT(word_error(Scalar::float32, "-1e999"), HasSubstr("float can hold"));
    EXPECT_THAT(word_error(Scalar::int32, "2147483648"), HasSubstr("2147483647"));
    EXPECT_THAT(word_error(Scalar::int32, "0.5"), HasSubstr("whole number"));
    EXPECT_THAT(word_error(Scalar::int32, "nan"), HasSubstr("whole number"));
    EXPECT_THAT(word_error(Scalar::int32, "inf"), HasSubstr("whole number"));
    EXPECT_THAT(word_error(Scalar::uint32, "-1"), HasSubstr("from 0 to 4294967295"));
    EXPECT_THAT(word_error(Scalar::uint32, "4294967296"), HasSubstr("whole number"));
    EXPECT_THAT(word_error(Scalar::boolean, "2"), HasSubstr("from 0 to 1"));
}

TEST(csv, inputs_take_columns_by_name_in_any_order) {
    const auto inputs = read_inputs(find_case("smsr/case_09"),
                                    parse_csv("note,along_x,p_y,p_x\nhello,0.25,0.5,0.75\n", "f.csv"));
    ASSERT_EQ(inputs.size(), 1u);
    EXPECT_THAT(inputs[0].words, ElementsAre(bits(0.75f), bits(0.5f), bits(0.25f)));
}

TEST(csv, inputs_with_masks) {
    const auto inputs = read_inputs(find_case("smsr/number"),
                                    parse_csv("mask,outside,texel_x,texel_y\n#./..,shadow,1,-1\n", "f.csv"));
    ASSERT_EQ(inputs.size(), 1u);
    EXPECT_EQ(format_mask(inputs[0].mask, '/'), "#./..");
    EXPECT_EQ(inputs[0].mask.outside, Outside::shadow);
    EXPECT_THAT(inputs[0].words, ElementsAre(1u, 0xffffffffu));
    const auto clamped =
        read_inputs(find_case("smsr/number"), parse_csv("mask,texel_x,texel_y\n#./..,1,1\n", "f.csv"));
    EXPECT_EQ(clamped.at(0).mask.outside, Outside::clamp);
}

TEST(csv, bad_inputs_are_named_with_row_and_column) {
    EXPECT_THAT(input_error("smsr/case_09", "p_x,p_y\n0,0\n"), HasSubstr("no column \"along_x\""));
    EXPECT_THAT(input_error("smsr/case_09", "p_x,p_y,along_x\n0,0,0\n0,zero,0\n"),
                StartsWith("f.csv: row 2, column p_y is \"zero\""));
    EXPECT_THAT(input_error("smsr/number", "texel_x,texel_y\n0,0\n"), HasSubstr("no column \"mask\""));
    EXPECT_THAT(input_error("smsr/number", "mask,texel_x,texel_y\n#./.,0,0\n"),
                StartsWith("f.csv: row 1, column mask: row 2 has 1 texels"));
    EXPECT_THAT(input_error("smsr/number", "mask,texel_x,texel_y\n#x/..,0,0\n"),
                HasSubstr("row 1, column 2 is 'x'"));
    EXPECT_THAT(
        input_error("smsr/number", "mask,outside,texel_x,texel_y\n#,dark,0,0\n"),
        AllOf(StartsWith("f.csv: row 1, column outside is \"dark\""), HasSubstr("clamp, lit or shadow")));
    EXPECT_THAT(input_error("smsr/number", "mask,texel_x,texel_y\n#,0.5,0\n"),
                StartsWith("f.csv: row 1, column texel_x is 0.5"));
}

TEST(csv, surrounds_come_back) {
    for (const Outside outside : {Outside::clamp, Outside::lit, Outside::shadow})
        EXPECT_EQ(parse_outside(to_string(outside), "here"), outside);
}

} // namespace
} // namespace gnomon
