// gnomon compare as people call it: what is told of two kernels, folders and revisions, on every way to name
// them, and that no kernel takes the program down.
#include "casegen/catalogue.h"
#include "casegen/sampling.h"
#include "casegen/versus/picture.h"
#include "runtime/files.h"
#include "runtime/image.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <regex>

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AnyOf;
using testing::BrokenKernels;
using testing::ChangedKernels;
using testing::expect_refused;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Ran;
using testing::run_gnomon;
using testing::TemporaryFolder;

const std::string kernels = testing::kernels_folder().string();

class compare_verb : public ::testing::Test {
protected:
    compare_verb() { fs::create_directories(no_regressions_); }

    Ran compare(const testing::Arguments& arguments) const {
        using testing::operator+;
        return run_gnomon(testing::Arguments{"compare"} + arguments +
                          testing::Arguments{"--regressions", no_regressions_.string()});
    }
    /// Expects the exit code.
    json compare_json(const testing::Arguments& arguments, int exit_code = 0) const {
        using testing::operator+;
        const Ran ran = compare(arguments + testing::Arguments{"--format", "json"});
        EXPECT_EQ(ran.exit_code, exit_code) << ran.out << ran.err;
        EXPECT_EQ(ran.err, "");
        return json::parse(ran.out, nullptr, false);
    }
    /// The only kernel of a comparison.
    json compare_one(const testing::Arguments& arguments, int exit_code = 0) const {
        const json all = compare_json(arguments, exit_code);
        EXPECT_EQ(all.at("kernels").size(), 1u) << all.dump(2);
        return all.at("kernels").at(0);
    }

    TemporaryFolder folder_;
    fs::path no_regressions_ = folder_.path() / "none";
};

std::string slow_case_09(int sines = 200) {
    return fmt::format("// Slow: sines that add nothing.\nfloat smsr_case_09(vec2 p, float along_x) {{\n"
                       "    float x = p.x;\n    for (int i = 0; i < {}; ++i) x = sin(x + 1.0);\n"
                       "    return 1.0 - p.y < along_x + (x > 2.0 ? 1.0 : 0.0) ? 0.0 : 1.0;\n}}\n",
                       sines);
}

TEST_F(compare_verb, a_folder_with_itself_is_all_the_same_code) {
    const json all = compare_json({kernels, kernels});
    EXPECT_TRUE(all.at("kernels").empty());
    EXPECT_EQ(all.at("same").get<std::size_t>(), find_cases("").size());
    EXPECT_THAT(compare({kernels, kernels, "smsr/case_*"}).out,
                HasSubstr("are the same code and were not run"));
}

TEST_F(compare_verb, other_names_and_comments_are_no_other_code) {
    const ChangedKernels changed("smsr/case_09.glsl", "    return 1.0 - p.y < along_x",
                                 "    float renamed = p.y; // a comment\n    return 1.0 - renamed < along_x");
    const fs::path again = folder_.path() / "again";
    fs::copy(changed.folder(), again, fs::copy_options::recursive);
    write_file(again / "smsr/case_09.glsl", std::regex_replace(read_file(again / "smsr/case_09.glsl"),
                                                               std::regex("renamed|a comment"), "other"));
    const json all = compare_json({changed.folder().string(), again.string(), "--no-time"});
    EXPECT_EQ(all.at("same").get<std::size_t>(), find_cases("").size());
    EXPECT_TRUE(all.at("kernels").empty()) << all.dump(2);
}

TEST_F(compare_verb, finds_every_sample_that_a_changed_constant_moves) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y < 0.75 * along_x");
    const json one = compare_one(
        {kernels, changed.folder().string(), "smsr/case_09", "--no-time", "--samples", "20000"}, 1);
    // The same inputs, by other means: the host's floats.
    const Case& c = find_case("smsr/case_09");
    const auto pool = std::make_shared<const EdgePool>(make_edge_pool(default_seed("masks")));
    const Sampler sampler(c, default_seed(c), pool, testing::fixtures_folder() / "pins/smsr/case_09.csv",
                          testing::fixtures_folder() / "worst/smsr/case_09.csv");
    std::size_t differ = 0, inside = 0;
    float least_y = 2;
    for (std::size_t i = 0; i < std::max<std::size_t>(20000, sampler.fixed_count()); ++i) {
        const std::vector<std::uint32_t> words = sampler.draw(i).words;
        const float y = std::bit_cast<float>(words[1]), along = std::bit_cast<float>(words[2]);
        if ((1.0f - y < along) == (1.0f - y < 0.75f * along)) continue;
        ++differ;
        if (!in_domain(c, arguments(c, words, nullptr))) continue;
        ++inside;
        least_y = std::min(least_y, y);
    }
    const json& difference = one.at("difference");
    EXPECT_GT(differ, 1000u);
    EXPECT_EQ(difference.at("differ").get<std::size_t>(), differ);
    EXPECT_EQ(difference.at("differ_in_domain").get<std::size_t>(), inside);
    EXPECT_EQ(difference.at("worst").at("absolute"), 1.0);
    EXPECT_EQ(difference.at("where").at(1).at("input"), "p.y");
    EXPECT_FLOAT_EQ(difference.at("where").at(1).at("from").get<float>(), least_y);
    EXPECT_TRUE(one.at("a").at("right").get<bool>());
    EXPECT_FALSE(one.at("b").at("right").get<bool>());
    EXPECT_THAT(one.at("accuracy").get<std::string>(), HasSubstr("B is WRONG where A is right"));
    // Either side's command gives what the report says.
    for (const char* side : {"a", "b"}) {
        const Ran ran = testing::run_shell(difference.at("worst").at(std::string("replay_") + side));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_THAT(ran.out,
                    HasSubstr(fmt::format(",{},", difference.at("worst").at(side).get<std::string>())));
    }
}

TEST_F(compare_verb, says_the_same_in_words) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y < 0.75 * along_x");
    const Ran ran = compare({kernels, changed.folder().string(), "smsr/*", "--no-time", "--samples", "3000"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, HasSubstr("B is WRONG where A is right"));
    EXPECT_THAT(ran.out, HasSubstr("smsr/visibility")) << "it includes the case";
    EXPECT_THAT(ran.out, HasSubstr("where     p.y from"));
    EXPECT_THAT(ran.out, HasSubstr("are the same code and were not run"));
    EXPECT_THAT(ran.out, Not(HasSubstr("\n  time ")));
    EXPECT_EQ(compare({changed.folder().string(), kernels, "smsr/case_09", "--no-time"}).exit_code, 0)
        << "only B can fail";
}

TEST_F(compare_verb, sees_a_slow_kernel_and_does_not_see_what_is_not_there) {
    // Both so slow that it does not matter what reading their inputs takes, which is hard to tell on a busy
    // machine.
    const std::string slow = folder_.write("slow.glsl", slow_case_09()).string(),
                      slower = folder_.write("slower.glsl", slow_case_09(4000)).string();
    const auto pace = [&](const std::string& a, const std::string& b) {
        const json one = compare_one({a, b, "--rounds", "12", "--samples", "2000"});
        EXPECT_EQ(one.at("difference").at("differ_in_domain"), 0);
        EXPECT_EQ(one.at("time").at("rounds"), 12);
        return one.at("time").at("verdict").get<std::string>();
    };
    EXPECT_EQ(pace(slow, slower), "SLOWER");
    EXPECT_EQ(pace(slower, slow), "FASTER");
    // An interval of 97.5 % may be wrong, on a busy machine; three in a row are a fault.
    std::vector<std::string> verdicts;
    while (verdicts.size() < 3 &&
           (verdicts.empty() || verdicts.back() == "SLOWER" || verdicts.back() == "FASTER"))
        verdicts.push_back(pace(slow, slow));
    EXPECT_THAT(verdicts.back(), AnyOf("SAME", "UNCERTAIN"));
}

TEST_F(compare_verb, takes_a_fixed_number_of_rounds) {
    const json one = compare_one({"smsr/case_09", "smsr/case_09", "--rounds", "7", "--samples", "500"});
    EXPECT_EQ(one.at("time").at("rounds"), 7);
    EXPECT_EQ(one.at("time").at("confidence"), 0.95);
    EXPECT_EQ(one.at("difference").at("differ"), 0);
}

TEST_F(compare_verb, sets_two_forms_of_one_quantity_side_by_side) {
    const json one =
        compare_one({"integral/sinc/a0", "integral/exact_theta/a0", "--no-time", "--samples", "2000"});
    EXPECT_EQ(one.at("kernel"), "integral/sinc/a0 / integral/exact_theta/a0");
    EXPECT_EQ(one.at("a").at("error").at("unit"), "of the scale")
        << "one tolerance is no multiple of the limit";
    EXPECT_GT(one.at("b").at("error").at("max").get<double>(), 0);
    EXPECT_GT(one.at("difference").at("differ").get<int>(), 0);
    EXPECT_THAT(one.at("difference").at("worst").at("replay_b").get<std::string>(),
                HasSubstr("gnomon eval integral/exact_theta/a0"));
}

TEST_F(compare_verb, reads_revisions_without_touching_the_work_tree) {
    // Only what this needs: a small folder of kernels in a repository of its own.
    const fs::path repository = folder_.path() / "repository", there = repository / "deep/kernels";
    fs::create_directories(there / "smsr");
    for (const char* name : {"case_01", "case_02", "case_09"})
        fs::copy(testing::kernels_folder() / fmt::format("smsr/{}.glsl", name), there / "smsr");
    const std::string git = fmt::format("git -C '{}' -c user.name=a -c user.email=a@b ", repository.string());
    const auto commit = [&](const char* message) {
        const Ran ran = testing::run_shell(fmt::format("{0} add -A && {0} commit -q -m {1}", git, message));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
    };
    ASSERT_EQ(testing::run_shell(fmt::format("git init -q '{}'", repository.string())).exit_code, 0);
    commit("first");
    std::string text = read_file(there / "smsr/case_09.glsl");
    text.replace(text.find("1.0 - p.y < along_x"), 19, "1.0 - p.y > along_x");
    write_file(there / "smsr/case_09.glsl", text);
    fs::copy(testing::kernels_folder() / "smsr/case_03.glsl", there / "smsr");
    fs::remove(there / "smsr/case_02.glsl");
    commit("second");
    write_file(there / "smsr/case_01.glsl", "uncommitted\n");

    const testing::Arguments options{"--kernels", there.string(), "--no-time", "--samples", "2000"};
    using testing::operator+;
    const json all = compare_json(testing::Arguments{"HEAD~1", "HEAD"} + options, 1);
    ASSERT_EQ(all.at("kernels").size(), 1u) << all.dump(2);
    EXPECT_EQ(all.at("kernels").at(0).at("kernel"), "smsr/case_09");
    EXPECT_EQ(all.at("same"), 1) << "what is not committed is not seen";
    EXPECT_EQ(all.at("only_a"), json::array({"smsr/case_02"}));
    EXPECT_EQ(all.at("only_b"), json::array({"smsr/case_03"})) << "not there yet, though it is now";
    EXPECT_TRUE(std::regex_match(all.at("a").get<std::string>(), std::regex(R"(HEAD~1 \([0-9a-f]+\))")));
    const json same = compare_json(testing::Arguments{"git:HEAD", "HEAD:"} + options);
    EXPECT_TRUE(same.at("kernels").empty());
    const json back = compare_json(testing::Arguments{"HEAD", "HEAD~1", "smsr/case_09"} + options);
    for (const char* side : {"a", "b"}) {
        const json& worst = back.at("kernels").at(0).at("difference").at("worst");
        const Ran ran = testing::run_shell(worst.at(std::string("replay_") + side));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_THAT(ran.out, HasSubstr(fmt::format(",{},", worst.at(side).get<std::string>())));
    }
    EXPECT_EQ(read_file(there / "smsr/case_01.glsl"), "uncommitted\n");
    EXPECT_THAT(testing::run_shell(git + "status --porcelain").out, " M deep/kernels/smsr/case_01.glsl\n");

    const auto refused = [&](const testing::Arguments& arguments, const std::string& what) {
        expect_refused(folder_, testing::Arguments{"compare"} + arguments, what);
    };
    refused({"HEAD~7", "HEAD", "--kernels", there.string()}, "no revision \"HEAD~7\"");
    refused({"git:--all", "HEAD", "--kernels", there.string()}, "names no git revision");
    fs::create_directories(repository / "new/smsr");
    fs::copy(testing::kernels_folder() / "smsr/case_01.glsl", repository / "new/smsr");
    refused({"HEAD", "HEAD", "--kernels", (repository / "new").string()}, "does not exist in revision HEAD");
    fs::create_directories(folder_.path() / "loose/smsr");
    fs::copy(testing::kernels_folder() / "smsr/case_01.glsl", folder_.path() / "loose/smsr");
    refused({"git:HEAD", "smsr/case_01", "--kernels", (folder_.path() / "loose").string()},
            "no git repository");
    const Ran without = run_gnomon({"compare", "HEAD", "HEAD", "--kernels", there.string()},
                                   {{"PATH", folder_.path().string()}});
    EXPECT_EQ(without.exit_code, 2);
    EXPECT_THAT(without.err, HasSubstr("git: not found"));
}

TEST_F(compare_verb, a_file_is_the_kernel_whose_function_it_defines) {
    const std::string flipped =
        folder_
            .write("mine.glsl", "float smsr_case_09(vec2 p, float along_x) {\n"
                                "    return 1.0 - p.y < 0.5 * along_x ? 0.0 : 1.0;\n}\n")
            .string();
    const json one = compare_one({"smsr/case_09", flipped, "--no-time", "--samples", "2000"}, 1);
    EXPECT_EQ(one.at("kernel"), "smsr/case_09");
    const json& worst = one.at("difference").at("worst");
    const Ran ran = testing::run_shell(worst.at("replay_b"));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr(fmt::format(",{},", worst.at("b").get<std::string>())));

    const std::string renamed =
        folder_
            .write("fast.glsl", "float helper(float x) { return 1.0 - x; }\n"
                                "float smsr_case_09_fast(const vec2 p, in float along) {\n"
                                "    return helper(p.y) < along ? 0.0 : 1.0;\n}\n")
            .string();
    expect_refused(folder_, {"compare", "smsr/case_09", renamed}, "--kernel NAME");
    const json named =
        compare_one({"smsr/case_09", renamed, "--kernel", "smsr/case_09", "--no-time", "--samples", "2000"});
    EXPECT_EQ(named.at("difference").at("differ"), 0);
    expect_refused(folder_, {"compare", "smsr/case_09", renamed, "--kernel", "smsr/case_01"},
                   "nor exactly one other function with its parameters");
}

TEST_F(compare_verb, draws_where_two_inputs_make_a_difference) {
    const std::string changed =
        folder_
            .write("mine.glsl", "float smsr_case_09(vec2 p, float along_x) {\n"
                                "    return 1.0 - p.y < 0.5 * along_x ? 0.0 : 1.0;\n}\n")
            .string();
    const fs::path file = folder_.path() / "where.png";
    const json one = compare_one({"smsr/case_09", changed, "--no-time", "--samples", "2000", "--image",
                                  file.string(), "--axes", "along_x,p.y", "--size", "64x32"},
                                 1);
    const Image image = read_png(file);
    ASSERT_EQ(image.width, 64);
    ASSERT_EQ(image.height, 32);
    std::size_t differ = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const float along = (static_cast<float>(x) + 0.5f) / 64, py = (static_cast<float>(y) + 0.5f) / 32;
            const bool lighter = 1 - py < along && !(1 - py < 0.5f * along);
            if (lighter) ++differ;
            ASSERT_EQ(image.at(x, y), lighter ? versus::larger_colour : versus::same_colour) << x << ' ' << y;
        }
    EXPECT_EQ(one.at("image").at("differ").get<std::size_t>(), differ);
    EXPECT_EQ(one.at("image").at("scale"), 1.0);
    const Ran text = compare({"smsr/case_09", changed, "--no-time", "--samples", "2000", "--image",
                              file.string(), "--at", "0.5,0.5,0.25"});
    EXPECT_THAT(text.out, HasSubstr("to the right p.y from 0 to 1; downwards along_x from 0 to 1"));
    EXPECT_THAT(text.out, HasSubstr("p = vec2(0x1p-1, 0x1p-1), along_x = 0x1p-2"));
    EXPECT_EQ(read_png(file).width, 512);
}

TEST_F(compare_verb, tells_a_hang_and_a_compile_error_of_its_side) {
    const BrokenKernels endless("endless");
    const json hung = compare_one(
        {kernels, endless.folder().string(), "smsr/case_01", "--time-limit", "1", "--samples", "3000"}, 1);
    EXPECT_EQ(hung.at("b").at("failure"), "timeout");
    EXPECT_TRUE(hung.at("a").at("right").get<bool>());
    EXPECT_FALSE(hung.contains("time"));
    const json reversed = compare_one({endless.folder().string(), kernels, "smsr/case_01", "--time-limit",
                                       "1", "--samples", "3000", "--no-time"});
    EXPECT_EQ(reversed.at("a").at("failure"), "timeout");
    EXPECT_TRUE(reversed.at("b").at("right").get<bool>());

    const std::string broken = folder_
                                   .write("broken.glsl", "float smsr_case_09(vec2 p, float along_x) {\n"
                                                         "    return nonsense;\n}\n")
                                   .string();
    const json refused = compare_one({"smsr/case_09", broken, "--no-time", "--samples", "500"}, 1);
    EXPECT_EQ(refused.at("b").at("failure"), "compile error");
    EXPECT_THAT(refused.at("b").at("message").get<std::string>(), HasSubstr("broken.glsl:2: "));
}

TEST_F(compare_verb, counts_what_is_lost_where_a_is_not_right_everywhere_either) {
    const auto write = [&](const char* name, const char* result) {
        return folder_
            .write(name,
                   fmt::format("float smsr_case_09(vec2 p, float along_x) {{\n    return {};\n}}\n", result))
            .string();
    };
    const std::string nearly = write("nearly.glsl", "1.0 - p.y < along_x ? (p.x > 0.9 ? 0.5 : 0.0) : 1.0"),
                      inverted = write("inverted.glsl", "1.0 - p.y < along_x ? 1.0 : 0.0"),
                      right = write("right.glsl", "1.0 - p.y < along_x ? 0.0 : 1.0");
    const json lost = compare_one({nearly, inverted, "--no-time", "--samples", "4000"}, 1);
    EXPECT_FALSE(lost.at("a").at("right").get<bool>());
    EXPECT_GT(lost.at("difference").at("wrong_where_a_is_right").get<int>(), 1000);
    EXPECT_THAT(lost.at("accuracy").get<std::string>(), HasSubstr("samples where A is"));
    const json won = compare_one({nearly, right, "--no-time", "--samples", "4000"});
    EXPECT_EQ(won.at("difference").at("wrong_where_a_is_right"), 0);
    compare_one({nearly, nearly, "--no-time", "--samples", "4000"}); // is wrong, and no worse
    // No results at all are worse than some that are right.
    const std::string broken = write("broken.glsl", "nonsense");
    EXPECT_THAT(compare_one({nearly, broken, "--no-time", "--samples", "4000"}, 1).at("accuracy"),
                HasSubstr("B on all samples where A is"));
    compare_one({broken, broken, "--no-time", "--samples", "4000"});
    compare_one({broken, nearly, "--no-time", "--samples", "4000"});
}

TEST_F(compare_verb, survives_a_crash_and_goes_on) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y < 0.5 * along_x");
    // A sum so long that the compiler's recursion runs out of stack.
    std::string text = "// Deep.\nfloat smsr_case_02(vec2 p) {\n    return p.x";
    for (int i = 0; i < 200000; ++i) text += "+p.x";
    write_file(changed.folder() / "smsr/case_02.glsl", text + ";\n}\n");
    const json all = compare_json(
        {kernels, changed.folder().string(), "smsr/case_0[29]", "--no-time", "--samples", "2000"}, 1);
    ASSERT_EQ(all.at("kernels").size(), 2u) << all.dump(2);
    EXPECT_EQ(all.at("kernels").at(0).at("b").at("failure"), "crash");
    EXPECT_TRUE(all.at("kernels").at(0).at("a").at("right").get<bool>());
    EXPECT_EQ(all.at("kernels").at(1).at("kernel"), "smsr/case_09");
    EXPECT_GT(all.at("kernels").at(1).at("difference").at("differ").get<int>(), 0);
}

TEST_F(compare_verb, refuses_what_it_cannot_do_with_one_line) {
    const auto refused = [&](const testing::Arguments& arguments, const std::string& what) {
        using testing::operator+;
        expect_refused(folder_, testing::Arguments{"compare"} + arguments, what);
    };
    const std::string file = folder_.write("mine.glsl", slow_case_09()).string();
    const std::string text = folder_.write("text.txt", "text").string();
    const std::string several =
        folder_.write("two.glsl", slow_case_09() + "float smsr_case_01(vec2 p) { return 0.0; }\n").string();
    fs::create_directories(folder_.path() / "empty");
    refused({"smsr/case_09", file, "--least-effect", "nan"}, "--least-effect");
    refused({"smsr/case_09", file, "--seconds", "nan"}, "--seconds");
    refused({"smsr/case_09"}, "B is required");
    refused({"smsr/case_9", "smsr/case_09"}, "\"smsr/case_9\" is no folder");
    refused({"/nowhere/mine.glsl", "smsr/case_09"}, "no such file");
    refused({text, "smsr/case_09"}, "not a kernel's file");
    refused({several, "smsr/case_09"}, "several kernels");
    refused({(folder_.path() / "empty").string(), kernels}, "holds no kernel");
    refused({kernels, kernels, "nothing_like_this"}, "nothing_like_this");
    refused({"smsr/case_09", "smsr/case_01"}, "cannot be compared");
    refused({"smsr/case_09", file, "smsr"}, "nothing to choose from");
    refused({kernels, kernels, "--kernel", "smsr/case_09"}, "neither");
    refused({kernels, kernels, "--image", "x.png"}, "--image shows one kernel");
    refused({"smsr/case_09", file, "--axes", "p.x,p.y"}, "--image FILE.png");
    refused({"smsr/case_09", file, "--image", "/nowhere/x.png"}, "/nowhere");
    refused({"smsr/case_09", file, "--image", (folder_.path() / "x.png").string(), "--axes", "q,p.x"},
            "no such input");
    refused({"smsr/case_09", file, "--image", (folder_.path() / "x.png").string(), "--at", "1,2"}, "--at");
    refused({"smsr/case_09", file, "--image", (folder_.path() / "x.png").string(), "--size", "0x5"},
            "--size");
    refused({"smsr/case_09", file, "--samples", "0"}, "--samples");
    refused({"smsr/case_09", file, "--rounds", "5", "--seconds", "1"}, "--rounds");
    refused({"smsr/case_09", file, "--seed", "x"}, "x");
    refused({"smsr/case_09", file, "--format", "xml"}, "xml");
    refused({"smsr/case_09", file, "--kernels", "/nowhere"}, "/nowhere");
}

} // namespace
} // namespace gnomon
