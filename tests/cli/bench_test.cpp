// gnomon bench as people call it; tests/measure has what it computes.
#include "runtime/files.h"
#include "tests/pipeline/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using ::testing::AllOf;
using testing::expect_refused;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run_well;

TEST(bench_verb, prints_a_table_and_writes_a_page) {
    const testing::TemporaryFolder folder;
    const std::string out = (folder.path() / "a/b").string();
    const std::string text =
        run_well({"bench", "smsr/case_0", "--samples", "100", "--rounds", "1", "--out", out}).out;
    EXPECT_THAT(text, AllOf(HasSubstr("smsr/case_09"), HasSubstr("median"), HasSubstr("ns"), HasSubstr(out)));
    const nlohmann::json json = testing::read_json(out + "/bench.json");
    EXPECT_EQ(json["groups"].size(), 9u);
    EXPECT_THAT(read_file(out + "/report.html"), HasSubstr("smsr/case_09"));
}

TEST(bench_verb, without_times_the_same_call_prints_the_same) {
    const testing::Arguments arguments{"bench", "smsr/case_09", "--no-time", "--samples", "50"};
    const std::string first = run_well(arguments).out;
    EXPECT_EQ(run_well(arguments).out, first);
    EXPECT_THAT(first, Not(HasSubstr("ns")));
}

TEST(bench_verb, refuses_what_it_cannot_do_with_one_line) {
    const testing::TemporaryFolder folder;
    const std::string file = folder.write("file", "").string();
    expect_refused(folder, {"bench", "smsr/case_99"}, "no kernel matches");
    expect_refused(folder, {"bench", "smsr", "--samples", "0"}, "--samples");
    expect_refused(folder, {"bench", "smsr", "--no-time", "--rounds", "3"}, "--rounds");
    expect_refused(folder, {"bench", "smsr", "--trigonometry", "fast"}, "portable");
    expect_refused(folder, {"bench", "smsr", "--out", file}, file);
    expect_refused(folder, {"bench", "smsr", "--kernels", "/nowhere"}, "/nowhere");
}

} // namespace
} // namespace gnomon
