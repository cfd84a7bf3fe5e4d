// A bench that is invented, as text, CSV, JSON and picture; and a small one that is measured.
#include "casegen/demo_scene.h"
#include "casegen/measure/hybrid/report.h"
#include "casegen/measure/hybrid/tables.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "tests/pipeline/view.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace gnomon::measure {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

HybridRow row(const char* name, bool exact, double milliseconds, double trace, std::size_t rays,
              std::size_t wrong) {
    HybridRow made{.technique = name, .exact = exact};
    made.times.milliseconds = milliseconds;
    made.times.steps = {{"detect", milliseconds - trace}, {"trace", trace}};
    made.times.frame.facing = 1000;
    made.times.frame.rays = rays;
    made.wrong = wrong;
    return made;
}

HybridBench invented() {
    HybridCombination c{.width = 640, .height = 480, .shadow_map = 256, .facing = 1000, .bvh = 5};
    c.rows = {row("raytraced", true, 10, 6, 1000, 0), row("rough", false, 5, 1, 100, 7),
              row("true", true, 8, 2, 300, 0), row("slow", true, 40, 0, 0, 0),
              row("auto", true, 8.4, 2, 300, 0)};
    c.choice = Choice{{{.name = "x", .milliseconds = {10}}, {.name = "true", .milliseconds = {8}}}, 1, 77};
    for (HybridRow& each : c.rows) each.break_even = break_even_nanoseconds(each.cost(), c.rows[0].cost());
    return {"a machine", "a scene", 12, 3, {c}};
}

TEST(HybridBench, FindsTheBestExactTechnique) {
    const HybridBench bench = invented();
    EXPECT_EQ(bench.combinations[0].best_exact().technique, "true"); // "rough" is faster, and wrong
    EXPECT_DOUBLE_EQ(bench.combinations[0].rows[1].wrong_share(), 0.007);
    EXPECT_DOUBLE_EQ(bench.combinations[0].rows[1].uncertain_share(), 0.1);
}

TEST(HybridBench, SaysLoudlyThatAnExactTechniqueIsWrong) {
    HybridBench bench = invented();
    EXPECT_THAT(broken_promises(bench), IsEmpty()); // "rough" promised nothing
    EXPECT_THAT(hybrid_page(bench), Not(HasSubstr("WRONG")));
    bench.combinations[0].rows[2].wrong = 1;
    ASSERT_EQ(broken_promises(bench).size(), 1u);
    EXPECT_THAT(broken_promises(bench)[0], HasSubstr("WRONG: true"));
    EXPECT_THAT(hybrid_page(bench), HasSubstr("WRONG: true"));
}

TEST(HybridBench, PrintsRatiosToRaytraced) {
    const HybridBench bench = invented();
    const Table table = hybrid_table(bench.combinations[0]);
    EXPECT_EQ(table.header[0], "technique");
    EXPECT_EQ(table.rows[2], (std::vector<std::string>{"true", "0.60", "0.20", "0.80", "8.00", "30.000",
                                                       "300", "0", "0.0", "6667", "2857", "0"}));
    const std::string text = to_text(bench);
    EXPECT_THAT(text, HasSubstr("640x480, shadow map 256"));
    EXPECT_THAT(text,
                HasSubstr("auto takes true: 1.05 of the best exact technique, true; calibration took 77 ms"));
}

TEST(HybridBench, WritesWhatProgramsRead) {
    const HybridBench bench = invented();
    const std::string csv = hybrid_csv(bench);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 6);
    EXPECT_THAT(csv, HasSubstr("640,480,256,rough,0,5,0.5,1000,100,0,0,7,"));
    const auto json = nlohmann::json::parse(hybrid_json(bench));
    const auto& c = json["combinations"][0];
    EXPECT_EQ(c["techniques"][1]["wrong_pixels"], 7);
    EXPECT_DOUBLE_EQ(c["auto"]["over_best_exact"].get<double>(), 1.05);
    EXPECT_EQ(c["auto"]["chosen"], "true");
    const testing::TemporaryFolder folder;
    write_report(folder.path(), bench);
    for (const char* file : {"report.html", "hybrid.json", "hybrid.csv", "hybrid_pareto.svg"})
        EXPECT_GT(read_file(folder.path() / file).size(), 100u) << file;
    const std::string svg = hybrid_chart(bench);
    EXPECT_THAT(svg,
                HasSubstr("slow, shadow map 256: 4.00 of raytraced, 0.000 % of pixels need a ray, 0 pixels "
                          "wrong, dominated"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg,
                Not(HasSubstr("rough, shadow map 256: 0.50 of raytraced, 10.000 % of pixels need a ray, 7 "
                              "pixels wrong, dominated")));
}

TEST(HybridBench, MeasuresEveryTechniqueInAView) {
    const Scene scene = demo_scene();
    const auto renderer = testing::make_renderer(scene, testing::demo_view(160, 120, 128));
    const HybridCombination c = measure_combination(*renderer, {.rounds = 1});
    EXPECT_EQ(c.rows.size(), hybrid_techniques().size() + 1); // and auto
    EXPECT_EQ(c.rows.front().technique, "raytraced");
    EXPECT_EQ(c.rows.back().technique, "auto");
    EXPECT_GT(c.facing, 1000u);
    EXPECT_GT(c.bvh, 0);
    for (const HybridRow& each : c.rows) {
        if (each.exact) EXPECT_EQ(each.wrong, 0u) << each.technique;
        EXPECT_GT(each.times.milliseconds, 0) << each.technique;
        EXPECT_EQ(each.times.frame.facing, c.facing) << each.technique;
    }
    EXPECT_EQ(c.rows.front().times.frame.rays, c.facing);
}

TEST(HybridBench, MeasuresOnlyWhatIsAskedFor) {
    const Scene scene = demo_scene();
    const auto renderer = testing::make_renderer(scene, testing::demo_view(80, 60, 64));
    const HybridCombination c = measure_combination(*renderer, {.techniques = {"lists"}, .rounds = 1});
    ASSERT_EQ(c.rows.size(), 2u);
    EXPECT_EQ(c.rows[1].technique, "lists");
    EXPECT_FALSE(c.choice);
    EXPECT_THROW(measure_combination(*renderer, {.techniques = {"list"}}), Error);
}

} // namespace
} // namespace gnomon::measure
