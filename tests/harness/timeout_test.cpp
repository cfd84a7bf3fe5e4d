// A kernel that does not end. In a child process, for the driver's threads go on with it until the process
// ends.
#include "tests/support/broken_kernels.h"
#include "tests/support/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>

namespace gnomon {
namespace {

using testing::BrokenKernels;
using ::testing::HasSubstr;
using testing::Ran;
using testing::run_gnomon;
using ::testing::StartsWith;

constexpr double patience = 60; // seconds; far more than the time limit of 1 and the start

class endless_kernel : public ::testing::TestWithParam<const char*> {};

TEST_P(endless_kernel, is_a_timeout_and_the_others_are_still_checked) {
    const BrokenKernels broken("endless");
    const Ran ran =
        run_gnomon({"check", "smsr/case_0[1234]", "--kernels", broken.folder().string(), "--time-limit", "1",
                    "--samples", "3000", "--jobs", GetParam(), "--format", "json"},
                   {}, patience);
    ASSERT_FALSE(ran.timed_out) << "the process hangs";
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_GE(ran.seconds, 1);
    std::map<std::string, std::string> verdicts;
    const nlohmann::json report = nlohmann::json::parse(ran.out);
    for (const nlohmann::json& entry : report["kernels"]) {
        verdicts[entry["kernel"]] = entry["verdict"];
        if (entry["verdict"] == "timeout")
            EXPECT_THAT(entry["message"].get<std::string>(),
                        AllOf(HasSubstr("1 s"), HasSubstr("--time-limit")));
    }
    EXPECT_EQ(verdicts, (std::map<std::string, std::string>{{"smsr/case_01", "timeout"},
                                                            {"smsr/case_02", "pass"},
                                                            {"smsr/case_03", "pass"},
                                                            {"smsr/case_04", "pass"}}));
}

INSTANTIATE_TEST_SUITE_P(jobs, endless_kernel, ::testing::Values("1", "2"));

TEST(endless_kernel_in_eval, is_one_line_and_exit_code_2) {
    const BrokenKernels broken("endless");
    const testing::TemporaryFolder folder;
    std::string rows = "p_x,p_y\n";
    for (int i = 0; i < 3000; ++i) rows += "0.5,0.25\n";
    const Ran ran = run_gnomon({"eval", "smsr/case_01", "--kernels", broken.folder().string(), "--time-limit",
                                "1", "--in", folder.write("in.csv", rows).string(), "--out",
                                (folder.path() / "out.csv").string()},
                               {}, patience);
    ASSERT_FALSE(ran.timed_out) << "the process hangs";
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err,
                AllOf(StartsWith("gnomon: smsr/case_01: did not end within 1 s"), HasSubstr("for ever")));
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.csv"));
}

} // namespace
} // namespace gnomon
