#include "casegen/fuzz/regression.h"

#include "runtime/error.h"
#include "runtime/files.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

namespace gnomon::fuzz {
namespace {

using ::testing::HasSubstr;

Regression example() {
    Input input{{std::bit_cast<std::uint32_t>(-3), 2, std::bit_cast<std::uint32_t>(0.1f), 0x7fc00000u},
                Mask(3, 2)};
    input.mask.set(1, 1, false);
    input.mask.outside = Outside::shadow;
    return {"smsr/visibility", "wrong in case 9", input, "0x1p+0", "0x0p+0", "exact", "by hand"};
}

std::string message_of(const std::string& text) {
    try {
        parse_regression(text, "FILE");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// The example's text with one thing replaced.
std::string changed(const std::string& from, const std::string& to) {
    std::string text = format_regression(example());
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(regression, reads_back_as_it_was_written) {
    const Regression before = example(), after = parse_regression(format_regression(before), "FILE");
    EXPECT_EQ(after.kernel, before.kernel);
    EXPECT_EQ(after.failure, before.failure);
    EXPECT_EQ(after.input.words, before.input.words);
    EXPECT_EQ(after.input.mask, before.input.mask);
    EXPECT_EQ(after.got, before.got);
    EXPECT_EQ(after.want, before.want);
    EXPECT_EQ(after.allowed, before.allowed);
    EXPECT_EQ(after.found, before.found);
    EXPECT_EQ(file_name(after), file_name(before));
}

TEST(regression, files_are_named_by_kernel_failure_and_input) {
    Regression other = example();
    EXPECT_TRUE(file_name(other).starts_with("smsr.visibility.wrong-in-case-9."));
    const std::string name = file_name(other);
    other.found = "in another way";
    EXPECT_EQ(file_name(other), name);
    other.input.words[0] = 7;
    EXPECT_NE(file_name(other), name);
}

TEST(regression, says_what_is_wrong_with_a_file) {
    EXPECT_THAT(message_of(""), HasSubstr("FILE: not JSON"));
    EXPECT_THAT(message_of("[1]"), HasSubstr("not a JSON object"));
    EXPECT_THAT(message_of("{}"), HasSubstr("has no \"kernel\""));
    EXPECT_THAT(message_of(changed("\"smsr/visibility\"", "7")), HasSubstr("\"kernel\" is not a text"));
    EXPECT_THAT(message_of(changed("smsr/visibility", "smsr/visible")),
                HasSubstr("there is no kernel \"smsr/visible\""));
    EXPECT_THAT(message_of(changed("\"found\"", "\"lost\"")), HasSubstr("unknown field \"lost\""));
    EXPECT_THAT(message_of(changed("\"texel_x\"", "\"texel_z\"")), HasSubstr("has no \"texel_x\""));
    EXPECT_THAT(message_of(changed("\"-3\"", "\"-3.5\"")), HasSubstr("whole number"));
    EXPECT_THAT(message_of(changed(".../.#.", ".../.x.")), HasSubstr("FILE"));
    EXPECT_THAT(message_of(changed("\"shadow\"", "\"dusk\"")), HasSubstr("clamp, lit or shadow"));
    for (const auto& [from, to] : {std::pair{"smsr/visibility", "two\\nlines"},
                                   {"\"found\"", "\"two\\nlines\""},
                                   {"\"shadow\"", "\"two\\nlines\""},
                                   {"\"mask\"", "\"two\\nlines\": \"1\", \"mask\""}})
        EXPECT_EQ(message_of(changed(from, to)).find('\n'), std::string::npos) << to;
    EXPECT_THAT(message_of(changed("\"mask\"", "\"more\": \"1\", \"mask\"")),
                HasSubstr("\"more\" is no input"));
}

TEST(regression, a_folder_is_read_whole_and_in_order) {
    const testing::TemporaryFolder folder;
    Regression one = example(), two = example();
    two.input.words[0] = 5;
    for (const Regression& each : {one, two})
        write_file(folder.path() / file_name(each), format_regression(each));
    write_file(folder.path() / "README.md", "what this is");
    const auto all = load_regressions(folder.path());
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all.at("smsr/visibility").size(), 2u);
    EXPECT_TRUE(load_regressions(folder.path() / "none").empty());
    EXPECT_THROW(load_regressions(folder.path() / "README.md"), Error);
    write_file(folder.path() / "overlooked.txt", format_regression(one));
    EXPECT_THROW(load_regressions(folder.path()), Error);
}

TEST(regression, those_of_this_repository_are_well_formed_and_well_named) {
    for (const auto& [kernel, all] : load_regressions(testing::source_folder() / "fixtures/regressions"))
        for (const Regression& each : all)
            EXPECT_TRUE(
                std::filesystem::exists(testing::source_folder() / "fixtures/regressions" / file_name(each)))
                << kernel << ": " << file_name(each);
}

} // namespace
} // namespace gnomon::fuzz
