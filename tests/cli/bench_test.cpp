// gnomon bench as people call it; tests/measure has what it computes.
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/environment.h"
#include "tests/support/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

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

TEST(bench_verb, times_one_kernel_without_variants) {
    const std::string text =
        run_well({"bench", "smsr/case_09", "--rounds", "2", "--samples", "100", "--repeats", "2"}).out;
    EXPECT_THAT(text, AllOf(HasSubstr("variant"), Not(HasSubstr("dominated by"))));
}

TEST(bench_verb, saves_a_baseline_and_tells_what_moved_against_it) {
    const testing::TemporaryFolder folder;
    const std::string file = (folder.path() / "b.json").string();
    const testing::Arguments measure{"bench", "smsr/case_0", "--no-time"};
    using testing::operator+;
    run_well(measure + testing::Arguments{"--samples", "100", "--save", file});
    const testing::Arguments against = measure + testing::Arguments{"--against", file};
    const std::string same = run_well(against).out;
    EXPECT_THAT(same, AllOf(HasSubstr("nothing moved: 9 kernels"), HasSubstr(file)));
    EXPECT_EQ(std::count(same.begin(), same.end(), '\n'), 1);

    // As if the kernel had been worse, and shorter.
    nlohmann::json json = testing::read_json(file);
    nlohmann::json& kernel = json["kernels"][4];
    const std::string name = kernel["kernel"];
    kernel["error"]["max"] = kernel["error"]["max"].get<double>() + 1;
    kernel["instructions"] = 1;
    folder.write("b.json", json.dump());
    const std::string better = run_well(against).out;
    EXPECT_THAT(better, AllOf(HasSubstr("BETTER     " + name), HasSubstr("instructions 1 -> "),
                              HasSubstr("2 moved, 0 of them for the worse")));
    json["kernels"].erase(0);
    folder.write("b.json", json.dump());
    EXPECT_THAT(run_well(against).out, HasSubstr("ADDED      smsr/case_01"));
}

TEST(bench_verb, what_becomes_worse_fails_and_says_so_in_every_format) {
    const testing::BrokenKernels broken("wrong_constant"); // smsr/case_02
    const testing::TemporaryFolder folder;
    const std::string file = (folder.path() / "b.json").string();
    run_well({"bench", "smsr/case_0", "--no-time", "--samples", "100", "--save", file});
    const auto against = [&](const std::string& format) {
        testing::Ran ran = testing::run_gnomon({"bench", "smsr/case_0", "--no-time", "--against", file,
                                                "--format", format, "--kernels", broken.folder().string()});
        EXPECT_EQ(ran.exit_code, 1) << ran.err;
        EXPECT_EQ(ran.err, "");
        return ran.out;
    };
    EXPECT_THAT(against("text"), AllOf(HasSubstr("WORSE    "), HasSubstr("smsr/case_02"),
                                       HasSubstr("WRONG: smsr/case_02"), Not(HasSubstr("smsr/case_03"))));
    const nlohmann::json json = nlohmann::json::parse(against("json"));
    EXPECT_EQ(json["against"]["moved"][0]["change"], "WORSE");
    EXPECT_EQ(json["against"]["moved"][0]["name"], "smsr/case_02");
    EXPECT_EQ(json["groups"].size(), 9u);
    const std::string junit = against("junit");
    EXPECT_EQ(testing::first_unbalanced(junit.substr(junit.find("<testsuite"))), "");
    EXPECT_THAT(junit, AllOf(HasSubstr("<testsuite name=\"gnomon bench\" tests=\"9\" failures=\"1\">"),
                             HasSubstr("<testcase classname=\"smsr\" name=\"smsr/case_03\""),
                             HasSubstr("<failure type=\"beyond tolerance\""), HasSubstr("WORSE than in")));
}

TEST(bench_verb, writes_one_page_of_kernels_and_techniques) {
    const testing::TemporaryFolder folder;
    const std::string out = (folder.path() / "page.html").string();
    const std::string scene = "fixtures/scenes/box.obj";
    const std::string text =
        run_well({"bench", "smsr/case_0", "--no-time", "--samples", "50", "--scenes", scene, "--out", out})
            .out;
    EXPECT_THAT(text, AllOf(HasSubstr("Techniques on " + scene), HasSubstr("rbsm-filter"), HasSubstr(out)));
    const std::string page = read_file(out);
    testing::expect_whole_page(page);
    EXPECT_EQ(folder.entries(), 1u);
    for (const char* technique : {"none", "nsm", "rsmss", "raytraced", "lists", "crsma-one-ring"})
        EXPECT_THAT(page, HasSubstr(std::string("<td>") + technique + "</td>"));
    EXPECT_THAT(page, Not(HasSubstr(testing::source_folder().string())));
}

// The committed baseline is what the kernels do. A change that moves an error or a count of instructions
// writes it anew.
const char* remedy = "\nIf this is meant, write the baseline anew and read its difference:\n"
                     "  gnomon bench --save fixtures/baseline.json && git diff fixtures/baseline.json\n";

void expect_as_committed(const testing::Arguments& what) {
    using testing::operator+;
    const std::string file = (testing::fixtures_folder() / "baseline.json").string();
    const testing::Ran ran = testing::run_gnomon(testing::Arguments{"bench"} + what +
                                                 testing::Arguments{"--no-time", "--against", file});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err << remedy;
    EXPECT_THAT(ran.out, HasSubstr("nothing moved: ")) << ran.out << remedy;
}

TEST(bench_baseline, is_what_the_kernels_do) { expect_as_committed({"--scenes", "none"}); }

TEST(bench_baseline, is_what_the_techniques_do) {
    expect_as_committed({"nsm", "--scenes", "demo,fixtures/scenes/hybrid/thin_ramp.obj"});
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
    expect_refused(folder, {"bench", "smsr", "--out", file + "/page.html"}, "page.html");
    expect_refused(folder, {"bench", "smsr", "--save", "/nowhere/b.json"}, "/nowhere/b.json");
    const std::string page = (folder.path() / "page.html").string();
    expect_refused(folder, {"bench", "smsr", "--out", page, "--save", page}, "--save");
    expect_refused(folder, {"bench", "smsr", "--format", "xml"}, "junit");
    expect_refused(folder, {"bench", "smsr", "--scenes", "demo,demo"}, "twice");
    expect_refused(folder, {"bench", "smsr", "--scenes", "none,demo"}, "none");
    expect_refused(folder, {"bench", "smsr", "--scenes", "/nowhere.ply"}, "/nowhere.ply");
}

TEST(bench_verb, refuses_a_baseline_that_is_none_with_one_line) {
    const testing::TemporaryFolder folder;
    const std::string empty = folder.write("empty.json", "").string();
    const std::string other = folder.write("other.json", "{\"kernels\": []}").string();
    const std::string cut = folder.write("cut.json", "{\"format\": 1, \"machine\": \"m\"}").string();
    expect_refused(folder, {"bench", "smsr", "--against", "/nowhere/b.json"}, "/nowhere/b.json");
    expect_refused(folder, {"bench", "smsr", "--against", folder.path().string()}, folder.path().string());
    expect_refused(folder, {"bench", "smsr", "--against", empty}, "empty.json: is not JSON");
    expect_refused(folder, {"bench", "smsr", "--against", other}, "other.json: is not a baseline");
    expect_refused(folder, {"bench", "smsr", "--against", cut}, "cut.json: has no \"driver\"");
    // The inputs are the baseline's, or errors could not be compared.
    const std::string good = (testing::fixtures_folder() / "baseline.json").string();
    expect_refused(folder, {"bench", "smsr", "--against", good, "--samples", "5"}, "--samples");
    expect_refused(folder, {"bench", "smsr", "--against", good, "--seed", "5"}, "--seed");
    const std::string out = (folder.path() / "page.html").string();
    expect_refused(folder, {"bench", "smsr", "--out", out, "--mutation", other}, "other.json");
    expect_refused(folder, {"bench", "smsr", "--out", out, "--coverage", empty}, "empty.json");
    expect_refused(folder, {"bench", "smsr", "--coverage", empty}, "--out");
}

} // namespace
} // namespace gnomon
