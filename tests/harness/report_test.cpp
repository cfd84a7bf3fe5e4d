// What a user sees of a kernel that fails, and the command that a failure offers to see it again.
#include "tests/support/broken_kernels.h"
#include "tests/support/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>
#include <sstream>

namespace gnomon {
namespace {

using testing::BrokenKernels;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using testing::Ran;
using testing::run_gnomon;
using testing::run_shell;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream stream(row);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

/// Runs the command and requires that its last columns are what the report says.
void expect_replay(const std::string& command, const std::vector<std::string>& results) {
    const Ran ran = run_shell(command);
    EXPECT_EQ(ran.exit_code, 0) << command << "\n" << ran.err;
    const std::vector<std::string> lines = lines_of(ran.out);
    ASSERT_EQ(lines.size(), 2u) << ran.out;
    const std::vector<std::string> cells = cells_of(lines[1]);
    ASSERT_GE(cells.size(), results.size());
    EXPECT_EQ(std::vector(cells.end() - std::ssize(results), cells.end()), results) << ran.out;
}

class failure_report : public ::testing::Test {
protected:
    static Ran check(const BrokenKernels& broken, const std::string& kernel, const std::string& format) {
        return run_gnomon({"check", kernel, "--kernels", broken.folder().string(), "--samples", "3000",
                           "--format", format, "--validation"});
    }
    static nlohmann::json entry(const Ran& ran) { return nlohmann::json::parse(ran.out)["kernels"].at(0); }
};

TEST_F(failure_report, text_has_call_got_want_allowed_and_a_command_that_shows_them_again) {
    const BrokenKernels broken("flipped_comparison");
    const Ran ran = check(broken, "smsr/case_09", "text");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.err, "");
    static const std::regex pattern(
        R"(FAIL smsr/case_09 \(wrong\)\n)"
        R"(  smsr_case_09\(p = vec2\(-?0x\S+p\S+, -?0x\S+p\S+\), along_x = -?0x\S+p\S+\)\n)"
        R"(  got (0x\S+), want (0x\S+), allowed input within 5.96e-08\n)"
        R"(  (gnomon eval smsr/case_09 .*)\n)"
        R"(  \d+ of 3000 samples fail; seed 0x[0-9a-f]+\n)");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(ran.out, match, pattern)) << ran.out;
    EXPECT_NE(match[1], match[2]);
    expect_replay(match[3], {match[1], match[2]});
    EXPECT_THAT(ran.out, HasSubstr("0 passed, 1 failed"));
}

TEST_F(failure_report, a_failure_on_a_mask_is_replayed_with_its_mask) {
    const BrokenKernels broken("off_by_one");
    const Ran ran = check(broken, "revectorize/traversal", "json");
    EXPECT_EQ(ran.exit_code, 1);
    const nlohmann::json report = entry(ran);
    EXPECT_EQ(report["verdict"], "wrong");
    EXPECT_THAT(
        report["worst_call"].get<std::string>(),
        AllOf(HasSubstr("revectorize_traversal(texel = ivec2("), HasSubstr("on a mask of 32 x 32, ")));
    // "ivec4(1, 2, -3, 4)" to its four numbers, behind those of the result the reference's.
    std::vector<std::string> numbers;
    for (const char* field : {"got", "want"}) {
        const std::string vector = report[field];
        ASSERT_THAT(vector, ::testing::StartsWith("ivec4("));
        for (std::string& cell : cells_of(vector.substr(6, vector.size() - 7)))
            numbers.push_back(cell.substr(cell.find_first_not_of(' ')));
    }
    expect_replay(report["replay"], numbers);
}

TEST_F(failure_report, nan_is_shown_and_replayed) {
    const BrokenKernels broken("nan");
    const nlohmann::json report = entry(check(broken, "smsr/case_03", "json"));
    EXPECT_EQ(report["got"], "nan");
    EXPECT_TRUE(report["worst_error"].is_null());
    expect_replay(report["replay"], {"nan", "0x0p+0"});
}

TEST_F(failure_report, outside_the_domain_the_range_is_what_was_wanted) {
    const BrokenKernels broken("out_of_range");
    const Ran ran = check(broken, "smsr/case_01", "text");
    EXPECT_THAT(ran.out,
                HasSubstr("got 0x1p+1, want anything from 0 to 1 (input outside the domain), allowed exact"));
    const nlohmann::json report = entry(check(broken, "smsr/case_01", "json"));
    EXPECT_FALSE(report.contains("want"));
    expect_replay(report["replay"], {"0x1p+1", "undefined"});
}

TEST_F(failure_report, a_result_that_was_not_written_is_nothing) {
    const BrokenKernels broken("never_written");
    const Ran ran = check(broken, "smsr/case_01", "text");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("FAIL smsr/case_01 (unwritten)"), HasSubstr("got nothing, want ")));
}

TEST_F(failure_report, a_compile_error_is_a_failure_with_its_line) {
    const BrokenKernels broken("syntax_error");
    const Ran ran = check(broken, "smsr/case_09", "text");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_09 (compile error)\n  kernels/smsr/case_09.glsl:5: "));
}

TEST_F(failure_report, junit_holds_the_failure) {
    const BrokenKernels broken("wrong_constant");
    const Ran ran = check(broken, "smsr/case_02", "junit");
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("tests=\"1\" failures=\"1\""), HasSubstr("<failure type=\"wrong\""),
                               HasSubstr("got 0x1p+0, want 0x0p+0")));
}

TEST_F(failure_report, is_whole_whatever_bytes_a_message_quotes) {
    const BrokenKernels broken("wrong_constant");
    const std::filesystem::path file = broken.folder() / "smsr/case_02.glsl";
    write_file(file, "#include \"a\xff.glslh\"\n" + read_file(file));
    const Ran json = check(broken, "smsr/case_02", "json");
    EXPECT_EQ(json.exit_code, 1) << json.err;
    const auto message = nlohmann::json::parse(json.out).at("kernels").at(0).at("message");
    EXPECT_THAT(message.get<std::string>(), HasSubstr("smsr/case_02.glsl:1: cannot include \"a\xef\xbf\xbd"));
    const Ran junit = check(broken, "smsr/case_02", "junit");
    EXPECT_EQ(junit.exit_code, 1) << junit.err;
    EXPECT_THAT(junit.out, AllOf(HasSubstr("cannot include &quot;a.glslh&quot;"), Not(HasSubstr("\xff"))));
}

TEST_F(failure_report, eval_refuses_a_result_that_was_not_written) {
    const BrokenKernels broken("never_written");
    const testing::TemporaryFolder folder;
    std::string rows = "p_x,p_y\n";
    for (int i = 0; i < 150; ++i) rows += "0.5,0.5\n";
    const Ran ran =
        run_gnomon({"eval", "smsr/case_01", "--kernels", broken.folder().string(), "--in",
                    folder.write("in.csv", rows).string(), "--out", (folder.path() / "out.csv").string()});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, AllOf(HasSubstr("gnomon: "), HasSubstr("1 of 150 results were never written")));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.csv"));
}

} // namespace
} // namespace gnomon
