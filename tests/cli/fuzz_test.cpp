// gnomon fuzz as people call it: what it finds, that it ends up in files that check replays, that it survives
// whatever kernels do, and that an interrupted campaign goes on.
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::BrokenKernels;
using testing::ChangedKernels;
using testing::expect_refused;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Ran;
using testing::run_gnomon;
using testing::TemporaryFolder;

/// A campaign with a folder of its own for what it finds.
class fuzz_verb : public ::testing::Test {
protected:
    Ran fuzz(const testing::Arguments& arguments, const fs::path& kernels = testing::kernels_folder()) {
        using testing::operator+;
        return run_gnomon(
            testing::Arguments{"fuzz"} + arguments +
            testing::Arguments{"--kernels", kernels.string(), "--regressions", found_.string()});
    }
    Ran check(const std::string& pattern, const fs::path& kernels) {
        return run_gnomon(
            {"check", pattern, "--kernels", kernels.string(), "--regressions", found_.string()});
    }
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        if (fs::is_directory(found_))
            for (const auto& entry : fs::directory_iterator(found_))
                names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }
    nlohmann::json file(std::size_t n = 0) const { return testing::read_json(found_ / files().at(n)); }

    TemporaryFolder folder_;
    fs::path found_ = folder_.path() / "regressions";
};

TEST_F(fuzz_verb, passes_what_is_right_and_leaves_nothing_behind) {
    const Ran ran = fuzz({"smsr/case_*", "--samples", "300000"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("0 failures"));
    EXPECT_THAT(ran.out, HasSubstr("seed 0x1"));
    EXPECT_TRUE(files().empty());
}

TEST_F(fuzz_verb, counts_as_people_write_it) {
    const Ran ran = fuzz({"smsr/case_09", "--samples", "2e5", "--format", "json"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_GE(nlohmann::json::parse(ran.out).at("evaluations").get<int>(), 200000);
}

TEST_F(fuzz_verb, shrinks_a_chain_s_mask_that_check_replays_for_ever) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "0.9 - p.y < along_x");
    const Ran ran = fuzz({"chain/smsr", "--samples", "4000", "--jobs", "1"}, changed.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAIL chain/smsr: another value transposed in case"));
    EXPECT_THAT(ran.out, HasSubstr("gnomon check chain/smsr"));
    ASSERT_GE(files().size(), 1u);
    for (std::size_t i = 0; i < files().size(); ++i) {
        const std::string mask = file(i).at("input").at("mask");
        EXPECT_LE(mask.size(), 11u) << mask << ": three rows of three";
    }
    const Ran red = check("chain/smsr", changed.folder());
    EXPECT_EQ(red.exit_code, 1);
    EXPECT_THAT(red.out, HasSubstr("another value transposed"));
    EXPECT_EQ(check("chain/smsr", testing::kernels_folder()).exit_code, 0);
}

TEST_F(fuzz_verb, shrinks_a_scene_to_a_few_triangles_that_check_replays_for_ever) {
    const ChangedKernels changed("hybrid/detect_sheet.comp", "SHADOWED : UNCERTAIN", "SHADOWED : LIT");
    const Ran ran = fuzz({"scene/sheet", "--samples", "2", "--jobs", "1"}, changed.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAIL scene/sheet: certain of light, which a triangle blocks"));
    ASSERT_EQ(files().size(), 1u);
    const nlohmann::json input = file().at("input");
    EXPECT_LE(input.at("triangles").size(), 3u);
    EXPECT_LE(input.at("settings").at("width"), 48);
    const Ran red = check("scene/sheet", changed.folder());
    EXPECT_EQ(red.exit_code, 1);
    EXPECT_THAT(red.out, HasSubstr("certain of light"));
    EXPECT_EQ(check("scene/sheet", testing::kernels_folder()).exit_code, 0);
}

TEST_F(fuzz_verb, shrinks_a_flipped_comparison_to_one_call_that_check_replays_for_ever) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y > along_x");
    const Ran ran = fuzz({"smsr/case_09", "--samples", "200000"}, changed.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_09: wrong"));
    ASSERT_EQ(files().size(), 1u) << "one failure, one file";
    const nlohmann::json input = file().at("input");
    for (const auto& [column, value] : input.items())
        EXPECT_THAT(value, ::testing::AnyOf("0x0p+0", "0x1p+0")) << column;
    std::smatch match;
    ASSERT_TRUE(std::regex_search(ran.out, match, std::regex("gnomon eval .*")));
    EXPECT_EQ(testing::run_shell(match[0]).exit_code, 0);

    const Ran red =
        run_gnomon({"check", "smsr/case_09", "--samples", "1", "--kernels", changed.folder().string(),
                    "--regressions", found_.string(), "--format", "json"});
    EXPECT_EQ(red.exit_code, 1);
    EXPECT_EQ(check("smsr/case_09", testing::kernels_folder()).exit_code, 0);

    const Ran again = fuzz({"smsr/case_09", "--samples", "200000"}, changed.folder());
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_THAT(again.out, HasSubstr("(known)"));
    EXPECT_THAT(again.out, HasSubstr("1 failures, 0 of them new"));
    EXPECT_EQ(files().size(), 1u);
}

TEST_F(fuzz_verb, shrinks_a_mask_to_three_by_three_texels) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y < 0.98 * along_x");
    const Ran ran = fuzz({"smsr/visibility", "--samples", "600000"}, changed.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    ASSERT_GE(files().size(), 1u);
    for (std::size_t i = 0; i < files().size(); ++i) {
        const std::string mask = file(i).at("input").at("mask");
        const auto rows = std::ranges::count(mask, '/') + 1;
        EXPECT_LE(rows, 3) << mask;
        EXPECT_LE(static_cast<long>(mask.size()) - (rows - 1), 3 * rows) << mask;
    }
}

TEST_F(fuzz_verb, finds_the_same_on_any_number_of_jobs_and_in_shards) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y < 0.98 * along_x");
    const testing::Arguments campaign{"smsr", "--samples", "9000000", "--format", "json"};
    using testing::operator+;
    struct Found {
        std::map<std::string, std::string> texts;
        std::uint64_t evaluations = 0;
    };
    const auto found_by = [&](const testing::Arguments& more) {
        fs::remove_all(found_);
        const Ran ran = fuzz(campaign + more, changed.folder());
        EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
        Found found{{}, nlohmann::json::parse(ran.out).at("evaluations").get<std::uint64_t>()};
        for (const std::string& name : files()) found.texts[name] = read_file(found_ / name);
        return found;
    };
    const Found one = found_by({"--jobs", "1"}), three = found_by({"--jobs", "3"});
    EXPECT_GE(one.texts.size(), 3u);
    EXPECT_EQ(one.texts, three.texts);
    EXPECT_EQ(one.evaluations, three.evaluations);
    const Found first = found_by({"--shard", "1/2"}), second = found_by({"--shard", "2/2"});
    EXPECT_FALSE(first.texts.empty() || second.texts.empty());
    EXPECT_EQ(one.evaluations, first.evaluations + second.evaluations);
}

TEST_F(fuzz_verb, survives_kernels_that_do_not_end_and_narrows_them_to_one_call) {
    const BrokenKernels broken("endless");
    const Ran ran = fuzz({"smsr/case_0[13]", "--samples", "100000", "--time-limit", "1"}, broken.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_01: timeout"));
    EXPECT_THAT(ran.out, HasSubstr("smsr_case_01(p = vec2("));
    ASSERT_EQ(files().size(), 1u);
    EXPECT_THAT(files()[0], HasSubstr("smsr.case_01.timeout"));
    const nlohmann::json json = nlohmann::json::parse(
        fuzz({"smsr/case_0[13]", "--samples", "100000", "--time-limit", "1", "--format", "json"},
             broken.folder())
            .out);
    EXPECT_GE(json.at("kernels").at(1).at("evaluations").get<int>(), 50000) << "the other one went on";
}

/// A smsr/case_09 that is wrong for one input in ten and crashes where the condition holds: nobody checks the
/// bounds of shared memory. What it reads there decides a result, or else nobody would read it.
class FatalKernels : public ChangedKernels {
public:
    explicit FatalKernels(const std::string& condition)
        : ChangedKernels(
              "smsr/case_09.glsl",
              "float smsr_case_09(vec2 p, float along_x) {\n"
              "    return 1.0 - p.y < along_x ? 0.0 : 1.0;",
              "shared uint memory[4];\n"
              "float smsr_case_09(vec2 p, float along_x) {\n"
              "    bool fatal = " +
                  condition +
                  ";\n"
                  "    uint beyond = fatal ? memory[floatBitsToUint(along_x) | 0x20000000u] : 0u;\n"
                  "    return 1.0 - p.y < 0.9 * along_x ? 0.0 : beyond == 77u ? 0.5 : 1.0;") {}
};

TEST_F(fuzz_verb, keeps_what_a_unit_found_before_it_took_its_worker_down) {
    // One in 131072, which this seed meets in its third batch.
    const FatalKernels fatal("(floatBitsToUint(p.x) * 2654435761u) >> 15 == 17u");
    const Ran ran = fuzz({"smsr/case_09", "--samples", "250000"}, fatal.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    ASSERT_EQ(files().size(), 2u) << ran.out;
    EXPECT_EQ(file(0).at("failure"), "crash");
    EXPECT_THAT(file(0).at("found").get<std::string>(), HasSubstr("batch 2, record"));
    EXPECT_EQ(file(1).at("failure"), "wrong");
    EXPECT_EQ(file(1).at("input").at("p_x"), "0x0p+0") << "it is shrunk";
}

TEST_F(fuzz_verb, keeps_what_it_found_although_shrinking_it_is_fatal) {
    // What the first failure shrinks to; drawn in the last batch too, so that asking again is fatal as well.
    const FatalKernels fatal("p == vec2(0.0, 0.25) && along_x == 0.8125");
    const Ran ran = fuzz({"smsr/case_09", "--samples", "250000"}, fatal.folder());
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_09: crash"));
    ASSERT_EQ(files().size(), 1u) << ran.out;
    EXPECT_EQ(file().at("failure"), "wrong");
    EXPECT_NE(file().at("input").at("p_x"), "0x0p+0") << "as it was met";
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
}

TEST_F(fuzz_verb, survives_a_crash_and_says_of_which_kernel) {
    const ChangedKernels changed("smsr/case_02.glsl", "return", "return 0.0 *");
    // A sum so long that the compiler's recursion runs out of stack.
    std::string text = "// Deep.\nfloat smsr_case_02(vec2 p) {\n    return p.x";
    for (int i = 0; i < 200000; ++i) text += "+p.x";
    write_file(changed.folder() / "smsr/case_02.glsl", text + ";\n}\n");
    const Ran ran = fuzz({"smsr/case_0[23]", "--samples", "100000"}, changed.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_02: crash"));
    EXPECT_THAT(ran.out, HasSubstr("died"));
    EXPECT_THAT(ran.out, HasSubstr("smsr/case_03"));
}

TEST_F(fuzz_verb, names_every_way_to_fail) {
    const std::vector<std::array<std::string, 3>> ways{
        {"nan", "smsr/case_03", "NaN"},
        {"nan_from_hostile_input", "smsr/case_02", "NaN, outside the domain"},
        {"out_of_range", "smsr/case_01", "out of range"},
        {"never_written", "smsr/case_01", "never written"},
        {"unstable", "smsr/case_01", "unstable"},
        {"syntax_error", "smsr/case_09", "compile error"}};
    for (const auto& [name, kernel, failure] : ways) {
        const BrokenKernels broken(name);
        const Ran ran = fuzz({kernel, "--samples", "20000"}, broken.folder());
        EXPECT_EQ(ran.exit_code, 1) << name << ran.out << ran.err;
        EXPECT_THAT(ran.out, HasSubstr(fmt::format("FAIL {}: {}", kernel, failure))) << name;
    }
}

TEST_F(fuzz_verb, files_nothing_that_does_not_fail_alone) {
    const ChangedKernels changed("smsr/case_09.glsl", "    return 1.0",
                                 "    if (gl_GlobalInvocationID.x > 5000u) return 0.37;\n    return 1.0");
    const Ran ran = fuzz({"smsr/case_09", "--samples", "100000"}, changed.folder());
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAIL smsr/case_09: wrong, among other inputs only"));
    EXPECT_TRUE(files().empty());
}

TEST_F(fuzz_verb, files_what_fails_alone_although_all_that_shrinking_tries_fails_among_others) {
    const ChangedKernels changed("smsr/case_09.glsl", "    return 1.0 - p.y < along_x",
                                 "    if (gl_GlobalInvocationID.x > 3u) return 0.37;\n"
                                 "    return 1.0 - p.y < 0.0 * along_x");
    EXPECT_EQ(fuzz({"smsr/case_09", "--samples", "100000"}, changed.folder()).exit_code, 1);
    ASSERT_EQ(files().size(), 1u);
    EXPECT_EQ(file().at("got"), "0x1p+0");
    EXPECT_EQ(file().at("want"), "0x0p+0");
    EXPECT_EQ(check("smsr/case_09", changed.folder()).exit_code, 1);
}

/// A campaign in a process group of its own, which gets the signal when the journal holds three lines.
std::string interrupted_campaign(const std::string& arguments, const std::string& journal,
                                 const std::string& signal) {
    return fmt::format(
        "setsid gnomon fuzz {0} --journal '{1}' & p=$!; "
        "while ! [ -s '{1}' ] || [ $(wc -l < '{1}') -lt 3 ]; do sleep 0.02; done; kill -{2} -$p; wait $p",
        arguments, journal, signal);
}

TEST_F(fuzz_verb, resumes_its_own_campaign_and_no_other) {
    const std::string journal = (folder_.path() / "journal").string();
    testing::run_shell(interrupted_campaign(
        fmt::format("smsr --samples 2e7 --regressions '{}'", found_.string()), journal, "INT"));
    const std::string kept = read_file(journal);
    const auto refused = [&](const testing::Arguments& arguments) {
        using testing::operator+;
        expect_refused(folder_,
                       testing::Arguments{"fuzz"} + arguments + testing::Arguments{"--journal", journal},
                       "the journal of another campaign");
    };
    refused({"smsr/case_09", "--samples", "2e7"});
    refused({"smsr", "--samples", "1e7"});
    refused({"smsr", "--samples", "2e7", "--seed", "2"});
    refused({"smsr", "--samples", "2e7", "--shard", "1/2"});
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y < 0.98 * along_x");
    refused({"smsr", "--samples", "2e7", "--kernels", changed.folder().string()});
    EXPECT_EQ(read_file(journal), kept);
    const Ran resumed = fuzz({"smsr", "--samples", "2e7", "--journal", journal});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_THAT(resumed.out, HasSubstr("before it was interrupted"));
    EXPECT_FALSE(fs::exists(journal));
    write_file(journal, kept);
    EXPECT_EQ(fuzz({"smsr/case_09", "--samples", "1e5", "--journal", journal, "--restart"}).exit_code, 0);
}

TEST_F(fuzz_verb, does_not_blame_a_kernel_for_the_end_of_its_process_group) {
    const Ran ran = testing::run_shell(
        interrupted_campaign(fmt::format("smsr --samples 1e10 --regressions '{}'", found_.string()),
                             (folder_.path() / "journal").string(), "TERM"));
    EXPECT_EQ(ran.exit_code, 1) << "it is not complete";
    EXPECT_THAT(ran.out, HasSubstr("interrupted; the same command goes on from here"));
    EXPECT_THAT(ran.out, HasSubstr("0 failures"));
}

TEST_F(fuzz_verb, goes_on_where_it_was_killed) {
    const ChangedKernels changed("smsr/case_09.glsl", "1.0 - p.y < along_x", "1.0 - p.y < 0.98 * along_x");
    const std::string journal = (folder_.path() / "journal").string();
    const testing::Arguments campaign{"smsr", "--samples", "9000000", "--jobs", "2", "--journal", journal};
    const auto killed = testing::run_shell(fmt::format(
        "gnomon fuzz smsr --samples 9000000 --jobs 2 --journal '{0}' --kernels '{1}' --regressions '{2}' & "
        "while ! [ -s '{0}' ] || [ $(wc -l < '{0}') -lt 8 ]; do sleep 0.02; done; kill -9 $!; wait $!",
        journal, changed.folder().string(), found_.string()));
    ASSERT_TRUE(fs::exists(journal)) << killed.err;
    const Ran resumed = fuzz(campaign, changed.folder());
    EXPECT_EQ(resumed.exit_code, 1) << resumed.err;
    EXPECT_THAT(resumed.out, HasSubstr("of them before it was interrupted"));
    EXPECT_FALSE(fs::exists(journal)) << "it has ended";
    std::map<std::string, std::string> texts;
    for (const std::string& name : files()) texts[name] = read_file(found_ / name);
    fs::remove_all(found_);
    const Ran whole = fuzz(campaign, changed.folder());
    for (const std::string& name : files()) EXPECT_EQ(texts[name], read_file(found_ / name)) << name;
    EXPECT_EQ(texts.size(), files().size());
    // The tables too, but for the time.
    EXPECT_EQ(resumed.out.substr(0, resumed.out.find("\nFAIL")),
              whole.out.substr(0, whole.out.find("\nFAIL")));
}

TEST_F(fuzz_verb, ends_when_it_is_interrupted_and_keeps_its_journal) {
    const std::string journal = (folder_.path() / "journal").string();
    const Ran ran = testing::run_shell(
        fmt::format("timeout -s INT 3 gnomon fuzz smsr --seconds 90 --journal '{}' --regressions '{}'",
                    journal, found_.string()));
    EXPECT_THAT(ran.out, HasSubstr("interrupted; the same command goes on from here"));
    EXPECT_LT(ran.seconds, 60);
    EXPECT_TRUE(fs::exists(journal));
}

TEST_F(fuzz_verb, refuses_what_it_cannot_do_with_one_line) {
    const auto refused = [&](const testing::Arguments& arguments, const std::string& what) {
        using testing::operator+;
        expect_refused(folder_, testing::Arguments{"fuzz"} + arguments, what);
    };
    refused({"nothing_like_this"}, "nothing_like_this");
    refused({"smsr", "--shard", "3/2"}, "--shard 3/2");
    refused({"smsr", "--shard", "0/2"}, "--shard 0/2");
    refused({"smsr", "--shard", "1/2x"}, "--shard 1/2x");
    refused({"smsr", "--seconds", "nan"}, "--seconds");
    refused({"smsr", "--seed", "x"}, "x");
    refused({"smsr", "--samples", "0"}, "--samples");
    refused({"smsr", "--samples", "1e"}, "--samples");
    refused({"smsr", "--samples", "0.5"}, "--samples");
    refused({"smsr", "--samples", "1e30"}, "--samples");
    refused({"smsr", "--samples", ""}, "--samples");
    refused({"smsr", "--seconds", "1", "--samples", "5"}, "--s");
    refused({"smsr", "--kernels", "/nowhere"}, "/nowhere");
    write_file(folder_.path() / "a_file", "");
    refused({"smsr", "--regressions", (folder_.path() / "a_file").string()}, "a_file: not a folder");
    refused({"smsr", "--regressions", "/proc/nowhere"}, "cannot make the folder /proc/nowhere");
    fs::create_directories(found_);
    write_file(found_ / "a.json", "{");
    refused({"smsr", "--regressions", found_.string()}, "a.json: not JSON (byte 2)");
    write_file(folder_.path() / "diary", "dear diary\n");
    refused({"smsr", "--journal", (folder_.path() / "diary").string()}, "not a journal");
    refused({"smsr", "--journal", (folder_.path() / "diary").string(), "--restart"}, "not a journal");
    EXPECT_EQ(read_file(folder_.path() / "diary"), "dear diary\n");
}

} // namespace
} // namespace gnomon
