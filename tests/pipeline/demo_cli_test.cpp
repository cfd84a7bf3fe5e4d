// gnomon demo.
#include "casegen/catalogue.h"
#include "runtime/files.h"
#include "runtime/image.h"
#include "tests/pipeline/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Demo, LeavesPicturesAndAReport) {
    const TemporaryFolder folder;
    const std::filesystem::path out = folder.path() / "new" / "demo";
    const Ran ran = run_well({"demo", "--out", out});
    for (const char* name :
         {"nsm.png", "nsm_errors.png", "smsr.png", "smsr_errors.png", "rsmss.png", "rsmss_errors.png",
          "rbsm-silhouette.png", "rbsm-filter.png", "rbsm-filter_errors.png", "raytraced.png"}) {
        const Image image = read_png(out / name);
        EXPECT_EQ(image.width, 1024) << name;
        EXPECT_EQ(image.height, 768) << name;
    }
    EXPECT_GT(read_png(out / "side_by_side.png").width, 1024);

    const nlohmann::json report = read_json(out / "report.json");
    EXPECT_GT(report["kernels"].size(), 60u);
    for (const nlohmann::json& kernel : report["kernels"]) {
        const std::string name = kernel["kernel"];
        EXPECT_EQ(kernel["verdict"], find_case(name).fails.empty() ? "pass" : "fails, as expected") << kernel;
    }
    EXPECT_THAT(read_file(out / "radiance/report.html"),
                AllOf(HasSubstr("<svg"), HasSubstr("columns_8"), HasSubstr("printed")));
    std::map<std::string, nlohmann::json> pixels;
    for (const nlohmann::json& technique : report["techniques"]) {
        const std::string name = technique["technique"];
        pixels[name] = technique["pixels"];
        EXPECT_THAT(ran.out, HasSubstr(name));
        EXPECT_EQ(pixels[name]["shadowed_by_truth"], pixels.begin()->second["shadowed_by_truth"]);
    }
    ASSERT_EQ(pixels.size(), 6u);
    EXPECT_EQ(pixels["raytraced"]["wrong_share_of_facing"], 0);
    EXPECT_LT(pixels["smsr"]["wrong_lit"], pixels["nsm"]["wrong_lit"]);
    EXPECT_LT(pixels["rsmss"]["wrong_share_of_facing"], pixels["smsr"]["wrong_share_of_facing"]);

    const std::string atlas = read_file(out / "atlas" / "index.html");
    EXPECT_THAT(atlas, HasSubstr("rsmss/case_31"));
    EXPECT_THAT(atlas, HasSubstr("demo scene"));
}

TEST(Demo, RefusesAFolderThatCannotBe) {
    const TemporaryFolder folder;
    expect_refused(folder, {"demo", "--out", folder.write("file", "")}, "file");
    expect_refused(folder, {"demo", "--out", folder.path() / "file" / "below"}, "below");
    expect_refused(folder, {"demo", "--out", ""}, "folder");
    std::filesystem::create_directories(folder.path() / "taken" / "report.json");
    expect_refused(folder, {"demo", "--out", folder.path() / "taken"}, "report.json");
}

} // namespace
} // namespace gnomon::testing
