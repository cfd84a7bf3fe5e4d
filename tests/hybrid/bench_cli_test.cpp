// gnomon bench hybrid as people call it.
#include "runtime/files.h"
#include "tests/pipeline/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(BenchHybridVerb, PrintsATablePerCombinationAndWritesAPage) {
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "a/b").string();
    const std::string text = run_well({"bench", "hybrid", "--sizes", "64x48,80x60", "--shadow-maps", "64",
                                       "--techniques", "lists,auto", "--rounds", "1", "--out", out})
                                 .out;
    EXPECT_THAT(text, AllOf(HasSubstr("64x48, shadow map 64"), HasSubstr("80x60, shadow map 64"),
                            HasSubstr("auto takes"), HasSubstr("pays from"), HasSubstr(out)));
    EXPECT_THAT(text, Not(HasSubstr("WRONG")));
    const nlohmann::json json = read_json(out + "/hybrid.json");
    ASSERT_EQ(json["combinations"].size(), 2u);
    ASSERT_EQ(json["combinations"][1]["techniques"].size(), 3u);
    EXPECT_EQ(json["combinations"][1]["techniques"][1]["wrong_pixels"], 0);
    EXPECT_THAT(read_file(out + "/report.html"), HasSubstr("<svg"));
}

TEST(BenchHybridVerb, RefusesWhatItCannotDoWithOneLine) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "").string();
    const Arguments hybrid{"bench", "hybrid"};
    expect_refused(folder, hybrid + Arguments{"--techniques", "list"}, "\"list\" is no hybrid technique");
    expect_refused(folder, hybrid + Arguments{"--techniques", "lists,lists"}, "twice");
    expect_refused(folder, hybrid + Arguments{"--sizes", "64"}, "--sizes");
    expect_refused(folder, hybrid + Arguments{"--sizes", "64x0"}, "0");
    expect_refused(folder, hybrid + Arguments{"--sizes", "64x48,64x48"}, "twice");
    expect_refused(folder, hybrid + Arguments{"--shadow-maps", "0"}, "--shadow-map");
    expect_refused(folder, hybrid + Arguments{"--shadow-maps", "big"}, "--shadow-maps");
    expect_refused(folder, hybrid + Arguments{"--rounds", "0"}, "--rounds");
    expect_refused(folder, hybrid + Arguments{"--size", "64x48"}, "--size");
    expect_refused(folder, hybrid + Arguments{"--out", file}, file);
    expect_refused(folder, hybrid + Arguments{"/nowhere.ply"}, "/nowhere.ply");
    // What bench alone knows would be ignored.
    expect_refused(folder, hybrid + Arguments{"--samples", "5"},
                   "--samples is not an option of bench hybrid");
    expect_refused(folder, {"bench", "--no-time", "hybrid"}, "--no-time is not an option of bench hybrid");
}

} // namespace
} // namespace gnomon::testing
