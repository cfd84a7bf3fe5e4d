// gnomon check on kernels that are right; tests/harness has those that are not.
#include "casegen/catalogue.h"
#include "tests/pipeline/cli.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace gnomon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::Ran;
using testing::operator+;
using testing::run_well;
using ::testing::StartsWith;

nlohmann::json check_json(testing::Arguments arguments) {
    arguments.insert(arguments.end(), {"--format", "json", "--validation"});
    return nlohmann::json::parse(run_well(arguments).out)["kernels"];
}

TEST(check_verb, passes_every_kernel) {
    const nlohmann::json kernels = check_json({"check", "--samples", "1000"});
    const std::vector<const Case*> cases = find_cases("");
    ASSERT_EQ(kernels.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const nlohmann::json& entry = kernels[i];
        EXPECT_EQ(entry["kernel"], cases[i]->name);
        const bool must_fail = !cases[i]->fails.empty();
        EXPECT_EQ(entry["verdict"], must_fail ? "fails, as expected" : "pass") << cases[i]->name;
        EXPECT_EQ(entry["failures"] == 0, !must_fail) << cases[i]->name;
        EXPECT_EQ(entry["source"], cases[i]->source);
        EXPECT_EQ(entry["allowed"], to_string(cases[i]->tolerance));
        EXPECT_GE(entry["samples"], 1000);
        EXPECT_TRUE(entry["worst_error"].is_number() || must_fail);
        EXPECT_GT(entry["nanoseconds_per_evaluation"], 0);
    }
}

TEST(check_verb, text_is_a_table_with_a_sum) {
    const std::string out = run_well({"check", "smsr/case_0[123]", "--samples", "500"}).out;
    EXPECT_THAT(out, AllOf(StartsWith("kernel "), HasSubstr("smsr/case_01  pass "),
                           HasSubstr("smsr/case_03  pass "), HasSubstr("\n3 passed, 0 failed\n"),
                           Not(HasSubstr("FAIL"))));
}

TEST(check_verb, the_worst_error_is_shown_on_a_pass_with_its_input) {
    const std::string out = run_well({"check", "revectorize/along"}).out;
    EXPECT_TRUE(std::regex_search(
        out,
        std::regex(
            R"(revectorize/along +pass .* [0-9.]+e-\d+ .*\n  worst at revectorize_along\(reach = ivec2\()")))
        << out;
}

TEST(check_verb, junit_is_well_formed) {
    const std::string out = run_well({"check", "smsr/case_*", "--samples", "200", "--format", "junit"}).out;
    EXPECT_THAT(out, StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                "<testsuite name=\"gnomon check\" tests=\"12\" failures=\"0\">\n"));
    static const std::regex element(
        R"(  <testcase classname="smsr" name="smsr/case_\d\d" time="\d+\.\d+"/>)");
    EXPECT_EQ(std::distance(std::sregex_iterator(out.begin(), out.end(), element), {}), 12);
    EXPECT_THAT(out, HasSubstr("</testsuite>"));
}

TEST(check_verb, the_same_seed_gives_the_same_report) {
    const auto without_time = [](nlohmann::json kernels) {
        for (nlohmann::json& entry : kernels) entry.erase("nanoseconds_per_evaluation");
        return kernels;
    };
    const testing::Arguments arguments{"check", "revectorize", "--samples", "2000", "--seed", "0x2a"};
    const nlohmann::json first = without_time(check_json(arguments));
    EXPECT_EQ(without_time(check_json(arguments + testing::Arguments{"--jobs", "3"})), first);
    EXPECT_EQ(first[0]["seed"], "0x000000000000002a");
    EXPECT_NE(without_time(check_json({"check", "revectorize", "--samples", "2000", "--seed", "43"})), first);
}

TEST(check_verb, takes_patterns_apart_by_commas) {
    const nlohmann::json checked = check_json({"check", "rsmss/case_09,smsr/case_0[89]", "--samples", "100"});
    std::vector<std::string> names;
    for (const nlohmann::json& entry : checked) names.push_back(entry.at("kernel"));
    EXPECT_THAT(names, ::testing::ElementsAre("smsr/case_08", "smsr/case_09", "rsmss/case_09"));
}

TEST(check_verb, refuses_what_it_cannot_do_with_one_line) {
    const testing::TemporaryFolder folder;
    const auto refused = [&](const testing::Arguments& arguments, const char* what) {
        testing::expect_refused(folder, testing::Arguments{"check"} + arguments, what);
    };
    refused({"smsr/case_9"}, "smsr/case_09");
    refused({"smsr/case_09,rsmss/case_32"}, "no kernel matches \"rsmss/case_32\"");
    refused({"smsr/case_09,"}, "a pattern in \"smsr/case_09,\" is empty");
    refused({"smsr/case_09,chain/smsr"}, "chain/smsr has no regressions on file");
    refused({"smsr/case\n_9"}, "case _9"); // what is quoted stays on the message's one line
    refused({"smsr/case_09", "--seed", "1\n2"}, "1 2");
    refused({"smsr/case_09", "--samples", "0"}, "--samples");
    refused({"smsr/case_09", "--samples", "many"}, "many");
    refused({"smsr/case_09", "--samples", "-1"}, "--samples");
    refused({"smsr/case_09", "--seed", "-1"}, "--seed");
    refused({"smsr/case_09", "--seed", "12x"}, "\"12x\"");
    refused({"smsr/case_09", "--seed", "18446744073709551616"}, "--seed");
    refused({"smsr/case_09", "--format", "yaml"}, "yaml");
    refused({"smsr/case_09", "--jobs", "1000"}, "--jobs");
    refused({"smsr/case_09", "--sample", "3"}, "--sample");
    refused({"smsr/case_09", "surplus"}, "surplus");
    refused({"smsr/case_09", "--regressions", "/nowhere"}, "'/nowhere' is no folder");
    refused({"smsr/case_09", "--device", "nonesuch"}, "llvmpipe");
    refused({"smsr/case_09", "--device", "99"}, "99");
    refused({"smsr/case_09", "--time-limit", "0"}, "--time-limit");
    refused({"smsr/case_09", "--time-limit", "soon"}, "soon");
}

TEST(program, refuses_unknown_verbs_and_options_with_one_line) {
    const testing::TemporaryFolder folder;
    testing::expect_refused(folder, {}, "subcommand");
    testing::expect_refused(folder, {"chekc"}, "chekc");
    testing::expect_refused(folder, {"list", "--loud"}, "--loud");
    testing::expect_refused(folder, {"list", "nonesuch"}, "nonesuch");
    testing::expect_refused(folder, {"describe"}, "KERNEL");
    testing::expect_refused(folder, {"describe", "smsr/case_9"}, "smsr/case_09");
}

TEST(program, says_which_kernels_folder_is_missing) {
    const Ran ran = testing::run_gnomon({"check", "smsr/case_09", "--kernels", "/nowhere/kernels"});
    EXPECT_NE(ran.exit_code, 0);
    EXPECT_THAT(ran.out + ran.err, HasSubstr("/nowhere/kernels"));
}

TEST(program, says_that_the_cache_folder_cannot_be_made) {
    const Ran ran = testing::run_gnomon({"check", "smsr/case_09"}, {{"GNOMON_CACHE", "/proc/none"}});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, AllOf(StartsWith("gnomon: "), HasSubstr("/proc/none")));
    EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
}

TEST(program, says_that_there_is_no_vulkan_driver) {
    const Ran ran = testing::run_gnomon({"check", "smsr/case_09"}, {{"VK_ICD_FILENAMES", "/nowhere.json"},
                                                                    {"VK_DRIVER_FILES", "/nowhere.json"}});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, AllOf(StartsWith("gnomon: "), HasSubstr("mesa-vulkan-drivers")));
    EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
}

} // namespace
} // namespace gnomon
