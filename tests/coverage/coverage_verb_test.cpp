// gnomon coverage as people call it.
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::expect_refused;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Ran;
using testing::run_gnomon;
using testing::TemporaryFolder;

TEST(coverage_verb, lists_what_was_not_reached_in_the_author_s_words) {
    // A branch that nothing can take.
    const testing::ChangedKernels kernels("smsr/case_09.glsl", "return 1.0 - p.y < along_x ? 0.0 : 1.0;",
                                          "if (p.x * p.x < -1.0) return 0.5;\n"
                                          "    return 1.0 - p.y < along_x ? 0.0 : 1.0;");
    const TemporaryFolder folder;
    const std::filesystem::path lcov = folder.path() / "kernels.info";
    const testing::Arguments arguments{"coverage",       "smsr/case_09", "--kernels",
                                       kernels.folder(), "--samples",    "1000",
                                       "--missing",      "--lcov",       lcov};
    const Ran ran = run_gnomon(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("smsr/case_09.glsl:4: `p.x * p.x < -1.0` was never true\n"));
    EXPECT_THAT(ran.out, Not(HasSubstr("along_x")));
    EXPECT_THAT(read_file(lcov), HasSubstr("BRDA:4,0,0,0\n"));
    using testing::operator+;
    EXPECT_EQ(run_gnomon(arguments + testing::Arguments{"--fail-under", "75"}).exit_code, 0);
    EXPECT_EQ(run_gnomon(arguments + testing::Arguments{"--fail-under", "75.1"}).exit_code, 1);
}

TEST(coverage_verb, writes_json_for_programs) {
    const Ran ran = run_gnomon({"coverage", "smsr/case_09", "--only-fixtures", "--format", "json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const nlohmann::json json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json["totals"]["branches"]["of"], 2);
    EXPECT_EQ(json["totals"]["branches"]["fixtures"], 2);
    EXPECT_EQ(json["files"][0]["branches"][0]["text"], "1.0 - p.y < along_x");
    EXPECT_EQ(json["kernels"][0]["samples"], 0);
}

TEST(coverage_verb, a_kernel_that_cannot_be_measured_is_an_exit_code) {
    const testing::ChangedKernels kernels("smsr/case_09.glsl", "along_x ?", "along_z ?");
    const Ran ran =
        run_gnomon({"coverage", "smsr/case_*", "--samples", "100", "--kernels", kernels.folder()});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_09: "));
    EXPECT_THAT(ran.out, HasSubstr("smsr/case_07.glsl"));
}

TEST(coverage_verb, refuses_what_it_cannot_do) {
    const TemporaryFolder folder;
    expect_refused(folder, {"coverage", "no/such"}, "no/such");
    expect_refused(folder, {"coverage", "smsr/case_09", "--lcov", folder.path() / "none" / "k.info"},
                   "k.info");
    expect_refused(folder, {"coverage", "smsr/case_09", "--kernels", folder.path() / "none"},
                   "no such folder");
    expect_refused(folder, {"coverage", "smsr/case_09", "--fail-under", "101"}, "--fail-under");
}

} // namespace
} // namespace gnomon
