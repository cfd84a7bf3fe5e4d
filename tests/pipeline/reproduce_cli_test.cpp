// gnomon reproduce.
#include "tests/pipeline/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

namespace gnomon::testing {
namespace {

using ::testing::HasSubstr;

TEST(Reproduce, SaysWhatToPassWhereTheModelIsMissing) {
    const Ran ran = run_gnomon({"reproduce", "thesis"}, {{"GNOMON_SCENES", ""}});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_THAT(ran.out, HasSubstr("skipped"));
    EXPECT_THAT(ran.out, HasSubstr("--scene"));
    EXPECT_THAT(ran.out, HasSubstr("GNOMON_SCENES"));
    EXPECT_EQ(ran.err, "");
}

TEST(Reproduce, RefusesWhatItCannotRead) {
    const TemporaryFolder folder;
    expect_refused(folder, {"reproduce", "thesis", "--scene", folder.path() / "no.ply"}, "no.ply");
    expect_refused(folder, {"reproduce", "thesis", "--views", "Flowers-Side"}, "Flowers-Side");
    expect_refused(folder, {"reproduce", "thesis", "--map-sizes", "1000"}, "1000");
    expect_refused(folder, {"reproduce", "phd"}, "phd");
}

/// A scene of another name and shape: all counts are made, and no target is met by chance.
TEST(Reproduce, ReportsEveryTargetThatAnotherSceneMisses) {
    const TemporaryFolder folder;
    const std::filesystem::path scene =
        folder.write("ground.obj", "v -200 0 -200\nv -200 0 200\nv 200 0 200\nv 200 0 -200\n"
                                   "vn 0 1 0\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n");
    const std::filesystem::path json = folder.path() / "counts.json";
    const Ran ran = run_well({"reproduce", "thesis", "--scene", scene, "--views", "Flowers-With",
                              "--map-sizes", "512", "--json", json});
    EXPECT_THAT(ran.out, HasSubstr("missed"));
    const nlohmann::json report = read_json(json);
    std::size_t held = 0, all = 0;
    for (const nlohmann::json& cell : report["compared"]) {
        EXPECT_EQ(cell["view"], "Flowers-With");
        EXPECT_TRUE(cell["map"] == 0 || cell["map"] == 512);
        ++all;
        const double apart = cell["here"].get<double>() - cell["printed"].get<double>();
        EXPECT_NEAR(cell["difference"].get<double>(), apart / std::max(1.0, cell["printed"].get<double>()),
                    1e-12);
        held += cell["holds"].get<bool>() ? 1 : 0;
        // An empty plane lies in the light.
        if (cell["quantity"] == "shadowed") EXPECT_EQ(cell["here"], 0);
        if (cell["quantity"] == "certain_wrong") EXPECT_EQ(cell["here"], 0);
    }
    EXPECT_EQ(all, 17u); // 4 of table 5, 4 of table 11, 9 of table 17
    EXPECT_LT(held, 6u); // CRSM's and CRSMA's wrong pixels are none in both
}

/// Which printed counts ours do not meet within the targets, at maps of 1024 and 2048 texels: see
/// docs/hybrid.md.
TEST(ReproduceOnTheThesisModel, CountsAreThePrintedOnesWithinTheTargets) {
    const char* scenes = std::getenv("GNOMON_SCENES");
    if (scenes == nullptr || *scenes == '\0')
        GTEST_SKIP() << "needs the thesis's model: run it with GNOMON_SCENES=FOLDER, where FOLDER holds "
                        "thesis_bench_normals.ply";
    const TemporaryFolder folder;
    const std::filesystem::path json = folder.path() / "counts.json";
    const Ran ran = run_gnomon({"reproduce", "thesis", "--map-sizes", "1024,2048", "--json", json}, {}, 280);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    std::set<std::string> missed;
    std::size_t targets = 0;
    const nlohmann::json report = read_json(json);
    for (const nlohmann::json& cell : report["compared"]) {
        if (cell["target"].is_null()) continue;
        ++targets;
        if (!cell["holds"].get<bool>())
            missed.insert(fmt::format("table {} {} {}", cell["table"].get<int>(),
                                      cell["technique"].get<std::string>(),
                                      cell["quantity"].get<std::string>()));
    }
    EXPECT_EQ(missed, (std::set<std::string>{"table 42 nsm wrong_lit", "table 45 nsm wrong_lit",
                                             "table 45 nsm wrong_shadowed", "table 70 beister certain_wrong",
                                             "table 70 beister uncertain", "table 62 crsma shadowed_certain",
                                             "table 62 crsma shadowed_uncertain"}));
    EXPECT_GT(targets, 700u);
}

} // namespace
} // namespace gnomon::testing
