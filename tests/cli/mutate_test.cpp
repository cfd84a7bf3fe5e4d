// gnomon mutate as people call it.
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

using testing::ChangedKernels;
using ::testing::HasSubstr;
using testing::Ran;
using testing::run_gnomon;
using testing::TemporaryFolder;

TEST(mutate_verb, kills_a_sample_of_every_family_of_cases) {
    const Ran ran = run_gnomon({"mutate", "smsr,rsmss,rbsm,revectorize", "--limit", "60"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("0 of 60 mutants survive"));
    EXPECT_THAT(ran.out, HasSubstr("rsmss/case_31"));
}

TEST(mutate_verb, reports_in_one_form_for_programs) {
    const TemporaryFolder folder;
    const Ran ran = run_gnomon(
        {"mutate", "smsr/case_09", "--format", "json", "--json", (folder.path() / "report.json").string()});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    const nlohmann::json report = nlohmann::json::parse(ran.out);
    ASSERT_EQ(report["kernels"].size(), 1u);
    const nlohmann::json& kernel = report["kernels"][0];
    EXPECT_EQ(kernel["name"], "smsr/case_09");
    EXPECT_EQ(kernel["mutants"].get<int>(), kernel["killed"].get<int>() + kernel["equivalent"].get<int>() +
                                                kernel["same_code"].get<int>() +
                                                kernel["stillborn"].get<int>());
    EXPECT_TRUE(kernel["survived"].empty());
    EXPECT_EQ(testing::read_json(folder.path() / "report.json")["kernels"][0]["killed"], kernel["killed"]);
}

TEST(mutate_verb, shows_one_mutant_and_lists_it_where_it_survives) {
    // A kernel whose branch nobody can reach: nothing changes when it goes.
    const ChangedKernels changed("smsr/case_09.glsl", "return 1.0",
                                 "if (along_x > 3.0 && along_x < 2.0) return 0.5;\n    return 1.0");
    const std::vector<std::string> kernels{"--kernels", changed.folder().string()};
    using testing::operator+;
    const Ran ran = run_gnomon(
        testing::Arguments{"mutate", "smsr/case_09", "--operators", "constant", "--format", "json"} +
        kernels);
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    const nlohmann::json survived = nlohmann::json::parse(ran.out)["kernels"][0]["survived"];
    const auto found = std::ranges::find_if(survived, [](const nlohmann::json& each) {
        return each["before"] == "0.5" && each["after"] == "1.0";
    });
    ASSERT_NE(found, survived.end()) << survived;
    EXPECT_EQ((*found)["file"], "smsr/case_09.glsl");
    EXPECT_EQ((*found)["line"], 4);
    EXPECT_EQ((*found)["operator"], "constant");

    const std::string id = (*found)["id"];
    const Ran one = run_gnomon(testing::Arguments{"mutate", "smsr/case_09", "--mutant", id} + kernels);
    EXPECT_EQ(one.exit_code, 1);
    EXPECT_THAT(one.out, HasSubstr("+ if (along_x > 3.0 && along_x < 2.0) return 1.0;"));
    EXPECT_THAT(one.out, HasSubstr("survived"));
    const Ran text =
        run_gnomon(testing::Arguments{"mutate", "smsr/case_09", "--mutant", id, "--show"} + kernels);
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_THAT(text.out, HasSubstr("along_x < 2.0) return 1.0;\n    return 1.0 - p.y"));
}

TEST(mutate_verb, asks_a_kernel_itself_before_its_mutants) {
    // Every mutant of a kernel that does not end does not end either, and none was noticed by a check.
    const testing::BrokenKernels endless("endless");
    const Ran ran = run_gnomon({"mutate", "smsr/case_0[13]", "--kernels", endless.folder().string(),
                                "--time-limit", "1", "--format", "json"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    const nlohmann::json report = nlohmann::json::parse(ran.out);
    EXPECT_THAT(report.at("complaints").dump(), HasSubstr("smsr/case_01 fails its check unchanged"));
    std::size_t killed = 0;
    for (const nlohmann::json& mutant : report.at("mutants")) {
        const bool of_endless = mutant.at("file") == "smsr/case_01.glsl";
        EXPECT_EQ(mutant.at("fate") == "not run", of_endless) << mutant;
        if (mutant.at("fate") != "killed") continue;
        ++killed;
        EXPECT_EQ(mutant.at("kernel"), "smsr/case_03");
        EXPECT_NE(mutant.at("how"), "");
    }
    EXPECT_GT(killed, 0u);
    EXPECT_GT(report.at("all").at("not_run").get<int>(), 0);
    EXPECT_TRUE(report.at("kernels").at(0).at("score").is_null());
    EXPECT_EQ(report.at("kernels").at(1).at("score"), 1);
}

TEST(mutate_verb, goes_on_behind_a_kernel_that_does_not_compile) {
    const testing::BrokenKernels broken("syntax_error");
    const Ran ran = run_gnomon({"mutate", "smsr/case_09,smsr/case_10", "--kernels", broken.folder().string(),
                                "--operators", "comparison"});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_THAT(ran.out,
                HasSubstr("ERROR smsr/case_09 fails its check unchanged: kernels/smsr/case_09.glsl:"));
    EXPECT_THAT(ran.out, ::testing::ContainsRegex("smsr/case_10 .* 100.0 %"));
}

TEST(check_of_a_border, tells_less_from_less_or_equal) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y <= along_x");
    const Ran ran = run_gnomon({"check", "smsr/case_09", "--kernels", changed.folder().string()});
    EXPECT_EQ(ran.exit_code, 1) << ran.out;
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_09 (wrong)"));
}

TEST(mutate_verb, refuses_what_it_does_not_know) {
    const TemporaryFolder folder;
    testing::expect_refused(folder, {"mutate", "smsr/case_09", "--operators", "constant,nonsense"},
                            "nonsense");
    testing::expect_refused(folder, {"mutate", "smsr/case_09", "--mutant", "0000000000"}, "0000000000");
    testing::expect_refused(folder, {"mutate", "smsr/case_99"}, "smsr/case_9");
    testing::expect_refused(folder, {"mutate", "smsr/case_09", "--show"}, "--mutant");
    const std::string list = folder.write("list.json", "[{}]").string();
    testing::expect_refused(folder, {"mutate", "smsr/case_09", "--equivalents", list}, "list.json: group 1");
}

} // namespace
} // namespace gnomon
