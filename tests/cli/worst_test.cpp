// gnomon worst as people call it; tests/measure has what it finds.
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace gnomon {
namespace {

using ::testing::AllOf;
using testing::BrokenKernels;
using testing::expect_refused;
using ::testing::HasSubstr;
using testing::Ran;
using testing::run_gnomon;

TEST(worst_verb, finds_a_broken_kernel_s_worst_and_prints_what_replays_it) {
    const BrokenKernels broken("wrong_constant");
    const auto folder = broken.folder().parent_path() / "worst";
    const Ran ran = run_gnomon({"worst", "smsr/case_02", "--kernels", broken.folder().string(), "--folder",
                                folder.string(), "--evaluations", "3000"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("before: nothing"), HasSubstr("which fails")));
    EXPECT_THAT(read_file(folder / "smsr/case_02.csv"), HasSubstr("p_x"));
    std::smatch match;
    ASSERT_TRUE(std::regex_search(ran.out, match, std::regex("gnomon eval .*")));
    EXPECT_EQ(testing::run_shell(match[0]).exit_code, 0);
}

TEST(worst_verb, ends_when_it_is_interrupted_and_keeps_what_it_found) {
    const BrokenKernels broken("wrong_constant");
    const auto folder = broken.folder().parent_path() / "worst";
    const Ran ran = testing::run_shell(
        fmt::format("timeout -s INT 3 gnomon worst smsr/case_02 --kernels '{}' --folder '{}' --seconds 90",
                    broken.folder().string(), folder.string()));
    EXPECT_THAT(ran.out, HasSubstr("interrupted"));
    EXPECT_LT(ran.seconds, 60);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / "smsr/case_02.csv"));
}

TEST(worst_verb, leaves_no_file_of_a_kernel_that_is_exact) {
    const testing::TemporaryFolder folder;
    const Ran ran =
        run_gnomon({"worst", "smsr/case_01", "--folder", folder.path().string(), "--evaluations", "1000"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("no input on which it is wrong"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "smsr/case_01.csv"));
}

TEST(worst_verb, refuses_what_it_cannot_do_with_one_line) {
    const testing::TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "smsr");
    write_file(folder.path() / "smsr/case_09.csv", "p_x,p_y,along_x\n0,zero,0\n");
    const std::string in = folder.path().string();
    expect_refused(folder, {"worst", "smsr/case_09", "--folder", in}, "case_09.csv: row 1, column p_y");
    expect_refused(folder, {"worst", "smsr/case_99", "--folder", in}, "smsr/case_");
    expect_refused(folder, {"worst", "smsr/case_09", "--seconds", "-1"}, "--seconds");
    expect_refused(folder, {"worst", "smsr/case_09", "--seconds", "1", "--evaluations", "5"},
                   "--evaluations");
    expect_refused(folder, {"worst", "smsr/case_09", "--folder", in + "/smsr/case_09.csv"}, "case_09.csv");
}

} // namespace
} // namespace gnomon
