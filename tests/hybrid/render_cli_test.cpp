// gnomon render of hybrids: --explain, --prune, auto.
#include "tests/pipeline/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const Arguments small{"--size", "96x64", "--shadow-map", "64", "--frames", "1"};

TEST(RenderHybrid, ExplainsWhatWasLeftOutInTextAndReport) {
    const TemporaryFolder folder;
    const std::string report = folder.path() / "report.json";
    // The camera looks into the sky: nothing faces the light.
    const Arguments sky{"render", "--technique", "lists", "--explain", "--camera-direction", "0,1,0.001"};
    const Ran ran = run_gnomon(sky + Arguments{"--report", report} + small);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out,
                AllOf(HasSubstr("left out          create maps"), HasSubstr("no pixel faces the light"),
                      HasSubstr("bytes per texel"), Not(HasSubstr("build BVH"))));
    const nlohmann::json hybrid = read_json(report)["hybrid"];
    EXPECT_EQ(hybrid["prune"], true);
    EXPECT_EQ(hybrid["rays"], 0);
    EXPECT_EQ(hybrid["left_out"].size(), 5u);
    EXPECT_EQ(hybrid["left_out"][0]["step"], "create maps");

    const Ran whole = run_gnomon(sky + Arguments{"--prune", "off", "--report", report} + small);
    EXPECT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_THAT(whole.out, HasSubstr("left out          nothing: --prune off"));
    EXPECT_TRUE(read_json(report)["hybrid"]["left_out"].empty());
}

TEST(RenderHybrid, TellsWhatAutoChose) {
    const TemporaryFolder folder;
    const std::string report = folder.path() / "report.json";
    const Ran ran =
        run_well(Arguments{"render", "--technique", "auto", "--explain", "--report", report} + small);
    EXPECT_THAT(ran.out, AllOf(HasSubstr("auto takes"), HasSubstr("rays")));
    const nlohmann::json json = read_json(report);
    EXPECT_EQ(json["technique"], "auto");
    EXPECT_EQ(json["pixels"]["wrong_lit"].get<int>() + json["pixels"]["wrong_shadowed"].get<int>(), 0);
    const nlohmann::json choice = json["hybrid"]["auto"];
    EXPECT_GE(choice["candidates"].size(), 2u);
    EXPECT_THAT(ran.out, HasSubstr("auto takes " + choice["chosen"].get<std::string>()));
    EXPECT_GT(choice["calibration_milliseconds"].get<double>(), 0);
}

TEST(RenderHybrid, RefusesPruneForOthers) {
    const TemporaryFolder folder;
    expect_refused(folder, {"render", "--technique", "smsr", "--prune", "off"}, "--prune off needs a hybrid");
    expect_refused(folder, {"render", "--technique", "lists", "--prune", "maybe"}, "--prune");
    expect_refused(folder, {"render", "--technique", "lists", "--assembly", "scene"}, "numbered cases");
    expect_refused(folder, {"render", "--technique", "nsm", "--explain"}, "hybrid");
}

} // namespace
} // namespace gnomon::testing
