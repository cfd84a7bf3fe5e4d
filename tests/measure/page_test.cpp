// The report's page as a text, and the pictures on it.
#include "casegen/measure/extras.h"
#include "casegen/measure/frames/section.h"
#include "casegen/measure/overview.h"
#include "casegen/measure/report.h"
#include "casegen/measure/scatter.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"
#include "tests/support/html.h"
#include "tests/support/sine_family.h"
#include "tests/support/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gnomon::measure {
namespace {

using ::testing::AllOf;
using testing::count_of;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::Not;

FrameRow row(const std::string& technique, double milliseconds, std::size_t wrong, Rgb colour) {
    FrameRow made;
    made.technique = technique;
    made.counts.facing = 1000;
    made.counts.wrong_lit = wrong;
    made.rmse = std::sqrt(static_cast<double>(wrong) / 1000);
    made.times.milliseconds = milliseconds;
    made.times.least = milliseconds / 2;
    made.times.most = 2 * milliseconds;
    made.times.rounds = {milliseconds};
    made.image = Image(4, 3, colour);
    made.errors = Image(4, 3, {static_cast<std::uint8_t>(wrong), 0, 0});
    return made;
}

/// nsm, a slow one that is no better, and two with the truth's picture.
SceneResult scene() {
    SceneResult made;
    made.view.scene = "<demo>";
    made.yardstick = "nsm";
    made.rows = {row("nsm", 1, 100, {1, 1, 1}), row("slow", 9, 100, {2, 2, 2}),
                 row("raytraced", 5, 0, {3, 3, 3}), row("traced", 4, 0, {3, 3, 3})};
    made.rows[1].dominated_by = 0;
    made.truth = made.rows[2].image;
    return made;
}

Bench measured(const testing::SineFamily& family, unsigned rounds) {
    BenchOptions options;
    options.kernels = family.kernels();
    options.samples = 100;
    options.repeats = 2;
    options.rounds = rounds;
    options.device = testing::validated();
    return bench(group(family.pointers(), std::array{Trigonometry::portable}, family.kernels()), options);
}

TEST(report_page, is_whole_and_needs_nothing_but_itself) {
    const testing::SineFamily family;
    for (const unsigned rounds : {0u, 1u}) {
        Report report;
        report.bench = measured(family, rounds);
        report.scenes = {scene(), scene()};
        report.moved = Moved{};
        report.moved->moves = {{Change::worse, "wave/<sinc>", "max error 1 -> 2", false}};
        report.baseline = "b & c.json";
        const std::string page = bench_page(report);
        testing::expect_whole_page(page);
        for (const char* part :
             {"wave/sinc", "wave/&lt;sinc&gt;", "b &amp; c.json", "Techniques on &lt;demo&gt;"})
            EXPECT_THAT(page, HasSubstr(part));
        EXPECT_THAT(page, Not(HasSubstr("<demo>")));
        EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
        EXPECT_EQ(count_of(page, "<script>"), 1u);
    }
}

TEST(report_page, the_checker_of_pages_sees_what_is_broken) {
    EXPECT_EQ(testing::first_unbalanced("<p>a<br>b</p><svg><path/></svg>"), "");
    EXPECT_EQ(testing::first_unbalanced("<p><b>a</p></b>"), "</p>");
    EXPECT_EQ(testing::first_unbalanced("<p>a"), "<p>");
    EXPECT_EQ(testing::first_unbalanced("<script>if (a < b) c</script></p>"), "</p>");
}

TEST(report_page, techniques_with_one_picture_share_it_and_truth_stands_first) {
    const std::string html = frames_section(scene());
    EXPECT_EQ(count_of(html, "<img "), 2 * 3u);
    EXPECT_EQ(count_of(html, "alt=\""), 2 * 3u);
    EXPECT_LT(html.find("<strong>raytraced, traced</strong>"), html.find("<strong>nsm</strong>"));
    EXPECT_LT(html.find("<strong>nsm</strong>"), html.find("<strong>slow</strong>"));
    EXPECT_THAT(html, HasSubstr("10.000 % of 1000 pixels wrong"));
}

TEST(report_page, the_technique_chart_has_a_mark_per_technique_and_measure) {
    const std::string svg = frames_chart(scene());
    for (const FrameRow& each : scene().rows) EXPECT_EQ(count_of(svg, "<title>" + each.technique + ": "), 2u);
    EXPECT_EQ(count_of(svg, "dominated by nsm"), 2u);
    EXPECT_EQ(count_of(svg, "fill=\"#fff\" stroke="), 2u);
    SceneResult untimed = scene();
    for (FrameRow& each : untimed.rows) each.times = {};
    EXPECT_EQ(frames_chart(untimed), "");
}

TEST(report_page, the_overview_has_a_mark_per_kernel_and_cost) {
    const testing::SineFamily family;
    const Bench timed = measured(family, 1), untimed = measured(family, 0);
    for (const Case& c : family.cases()) {
        EXPECT_EQ(count_of(overview_chart(timed), "<title>" + c.name + ": "), 2u);
        EXPECT_EQ(count_of(overview_chart(untimed), "<title>" + c.name + ": "), 1u);
    }
    const Table table = overview_table(timed);
    ASSERT_EQ(table.rows.size(), 4u);
    for (const auto& cells : table.rows) EXPECT_EQ(cells.size(), table.header.size());
    EXPECT_EQ(overview_table(untimed).header.size() + 4, table.header.size());
    EXPECT_THAT(to_sortable_html(table), AllOf(HasSubstr("<caption>"), HasSubstr("scope=\"col\"")));
}

TEST(report_page, dots_that_are_not_finite_or_zero_have_lanes_of_their_own) {
    Scatter scatter{"t", {}, {"a"}, {{"error", "cost", {}}}};
    for (const double error : {0.0, 1e-6, HUGE_VAL, std::nan("")}) {
        Dot dot;
        dot.cost = 10;
        dot.error = error;
        dot.title = "dot";
        scatter.panels[0].dots.push_back(dot);
    }
    Dot nowhere;
    nowhere.cost = std::nan("");
    nowhere.title = "nowhere";
    scatter.panels[0].dots.push_back(nowhere);
    const std::string svg = scatter_svg(scatter);
    EXPECT_EQ(count_of(svg, "<title>dot"), 4u);
    EXPECT_EQ(count_of(svg, "nowhere"), 0u);
    EXPECT_EQ(count_of(svg, "nan"), 0u);
    EXPECT_EQ(scatter_svg({}), "");
}

constexpr const char* mutation =
    R"({"kernels": [{"name": "smsr/case_09", "mutants": 10, "killed": 5, "equivalent": 2, "tolerated": 1,
 "same_code": 1, "stillborn": 1, "survived": [{"id": "m1", "file": "smsr/case_09.glsl", "line": 3, "column": 7,
 "operator": "comparison", "before": "a < b", "after": "a <= b"}]},
 {"name": "smsr/case_10", "mutants": 10, "killed": 5, "equivalent": 2, "tolerated": 1,
 "same_code": 1, "stillborn": 1, "survived": [{"id": "m1"}]}],
 "all": {"mutants": 14, "killed": 9, "equivalent": 2, "tolerated": 1,
 "same_code": 1, "stillborn": 1, "survived": [{"id": "m1", "file": "smsr/case_09.glsl", "line": 3, "column": 7,
 "operator": "comparison", "before": "a < b", "after": "a <= b"}]}, "more": 1})";
constexpr const char* coverage = R"({"totals": {"lines": {"fixtures": 3, "all": 4, "of": 8}, "branches":
 {"fixtures": 0, "all": 0, "of": 0}, "functions": {"fixtures": 1, "all": 1, "of": 1}}, "files": [{"file":
 "smsr/case_09.glsl", "totals": {"lines": {"fixtures": 3, "all": 4, "of": 8}, "branches": {"fixtures": 0, "all": 0,
 "of": 0}, "functions": {"fixtures": 1, "all": 1, "of": 1}}}]})";

TEST(report_page, mutation_scores_and_coverage_have_sections) {
    EXPECT_THAT(mutation_section(mutation, "m.json"),
                AllOf(HasSubstr("83.3"), HasSubstr("90.0"), HasSubstr("smsr/case_09.glsl:3:7"),
                      HasSubstr("a &lt;= b"), HasSubstr("smsr/case_09, smsr/case_10")));
    EXPECT_EQ(count_of(mutation_section(mutation, "m.json"), "smsr/case_09.glsl:3:7"),
              1u); // once, not by kernel
    EXPECT_THAT(coverage_section(coverage, "c.json"),
                AllOf(HasSubstr("3/8"), HasSubstr("37.5"), HasSubstr("4/8"), HasSubstr("all files")));
    EXPECT_EQ(testing::first_unbalanced(mutation_section(mutation, "m") + coverage_section(coverage, "c")),
              "");
}

TEST(report_page, what_is_no_mutation_or_coverage_file_is_refused_with_where_it_is_wrong) {
    for (const char* bad :
         {"", "[]", "{\"kernels\": 1}", "{\"kernels\": [{}]}", "{\"kernels\": [{\"name\": \"k\"}]}",
          R"({"kernels": [{"name": "k", "mutants": 0, "killed": 0, "equivalent": 0, "tolerated": 0,
              "same_code": 0, "stillborn": 0, "survived": []}]})"})
        EXPECT_THAT(error_of([&] { mutation_section(bad, "m.json"); }),
                    AllOf(HasSubstr("m.json"), Not(HasSubstr("\n"))))
            << bad;
    for (const char* bad : {"", "[]", "{\"totals\": {}}", R"({"totals": {"lines": 3}})"})
        EXPECT_THAT(error_of([&] { coverage_section(bad, "c.json"); }),
                    AllOf(HasSubstr("c.json"), Not(HasSubstr("\n"))))
            << bad;
}

} // namespace
} // namespace gnomon::measure
