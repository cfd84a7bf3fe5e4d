// gnomon watch as people and editors use it: it stays, and says after every save what became of it.
#include "casegen/catalogue.h"
#include "casegen/sampling.h"
#include "casegen/watch/texts.h"
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/running.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <fstream>
#include <memory>
#include <set>
#include <thread>

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::Arguments;
using testing::BrokenKernels;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Running;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using Json = nlohmann::json;

class watch_verb : public ::testing::Test {
protected:
    void SetUp() override { fs::copy(testing::kernels_folder(), kernels_, fs::copy_options::recursive); }

    Arguments arguments(const Arguments& more) const {
        using testing::operator+;
        return Arguments{"watch", "--kernels", kernels_.string()} + more;
    }
    /// Starts it, and lets it check everything once.
    void watch(const Arguments& more) {
        using testing::operator+;
        running_ = std::make_unique<Running>(arguments(Arguments{"--format", "json"} + more));
        EXPECT_EQ(next("watching").value("polls", true), std::ranges::find(more, "--poll") != more.end());
        EXPECT_EQ(next("settled").value("edit", 1), 0);
    }
    /// The next event of this kind. Those before it are in `passed_`.
    Json next(const std::string& kind) {
        passed_.clear();
        while (const std::optional<std::string> line = running_->line()) {
            Json event = Json::parse(*line);
            if (event.at("event") == kind) return event;
            passed_.push_back(std::move(event));
        }
        ADD_FAILURE() << "no " << kind << " came; before that: " << Json(passed_).dump(2);
        return Json::object();
    }
    std::string text(const std::string& file) const { return read_file(kernels_ / file); }
    /// As an editor that overwrites does it.
    void save(const std::string& file, const std::string& bytes) const {
        std::ofstream(kernels_ / file, std::ios::binary) << bytes;
    }
    /// As one that writes another file and renames it.
    void replace(const std::string& file, const std::string& bytes) const {
        write_file(kernels_ / file, bytes);
    }
    static std::string changed(std::string text, const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, text.npos) << "does not say " << from;
        if (at != text.npos) text.replace(at, from.size(), to);
        return text;
    }
    int interrupted() const {
        running_->signal(SIGINT);
        return running_->exit_code();
    }

    TemporaryFolder folder_;
    fs::path kernels_ = folder_.path() / "kernels";
    std::unique_ptr<Running> running_;
    std::vector<Json> passed_;
    const std::string case_09_ = "smsr/case_09.glsl";
};

TEST_F(watch_verb, a_comment_that_is_saved_at_once_leaves_the_edit_before_it_its_time) {
    watch({"smsr/case_09"});
    const std::string edited = changed(text(case_09_), "1.0 - p.y < along_x", "1.0 - p.y < 0.9 * along_x");
    save(case_09_, edited);
    next("verdict");
    save(case_09_, edited + "// A comment.\n");
    Json event = next("time");
    EXPECT_EQ(event.at("edit"), 1);
    EXPECT_GT(event.at("nanoseconds_after"), 0);
}

TEST_F(watch_verb, says_after_a_save_what_is_wrong_what_moved_and_what_it_costs) {
    watch({"smsr/case_09", "smsr/case_01"});
    const std::string right = text(case_09_);
    save(case_09_, changed(right, "1.0 - p.y < along_x", "1.0 - p.y > along_x"));
    Json event = next("verdict");
    EXPECT_EQ(event.at("kernel"), "smsr/case_09");
    EXPECT_EQ(event.at("verdict"), "wrong");
    EXPECT_EQ(event.at("good"), false);
    EXPECT_EQ(event.at("edit"), 1);
    EXPECT_LE(event.at("worst_error_before"), 0x1p-24);
    EXPECT_EQ(event.at("worst_error"), Json(nullptr)) << "no input near enough has this result";
    EXPECT_THAT(event.at("worst_call"), StartsWith("smsr_case_09(p = vec2("));
    EXPECT_THAT(event.at("replay"), HasSubstr("gnomon eval smsr/case_09 --kernels"));
    EXPECT_GT(event.at("failures"), 1000);
    const Json moved = event.at("moved");
    EXPECT_GE(moved.at("samples"), event.at("failures"));
    EXPECT_EQ(moved.at("largest"), 1);
    EXPECT_THAT(moved.at("call"), StartsWith("smsr_case_09(p = vec2("));
    EXPECT_NE(moved.at("before"), moved.at("after"));
    EXPECT_EQ(next("settled").at("bad"), 1);
    event = next("time");
    EXPECT_EQ(event.at("kernel"), "smsr/case_09");
    EXPECT_GT(event.at("nanoseconds_before"), 0);
    EXPECT_GT(event.at("nanoseconds_after"), 0);
    EXPECT_EQ(event.at("same_results_when_optimised"), true);

    save(case_09_, changed(right, "1.0 - p.y < along_x", "1.0 < along_x + p.y"));
    event = next("verdict");
    EXPECT_EQ(event.at("edit"), 2);
    EXPECT_EQ(event.at("good"), true) << event.dump(2);
    EXPECT_EQ(event.at("worst_error_before"), Json(nullptr));
    EXPECT_EQ(next("settled").at("bad"), 0);
    EXPECT_EQ(interrupted(), 0);
    EXPECT_EQ(next("end").at("bad"), 0);
}

TEST_F(watch_verb, counts_exactly_the_results_that_moved) {
    watch({"smsr/case_0[12]", "--no-times", "--samples", "4096"});
    save("smsr/case_01.glsl",
         changed(text("smsr/case_01.glsl"), "return 1.0", "return p.x == 0.0 ? 0.5 : 1.0"));
    const Json event = next("verdict");
    const Case& c = find_case("smsr/case_01");
    const fs::path fixtures = testing::source_folder() / "fixtures";
    const Sampler sampler(c, default_seed(c),
                          std::make_shared<const EdgePool>(make_edge_pool(default_seed("masks"))),
                          fixtures / "pins/smsr/case_01.csv", fixtures / "worst/smsr/case_01.csv");
    std::size_t at_zero = 0;
    for (std::size_t i = 0; i < event.at("samples").get<std::size_t>(); ++i)
        if (std::bit_cast<float>(sampler.draw(i).words[0]) == 0) ++at_zero;
    EXPECT_GT(at_zero, 100u);
    EXPECT_EQ(event.at("moved").at("samples"), at_zero);
    EXPECT_GT(event.at("failures"), 100);
    EXPECT_EQ(event.at("moved").at("largest"), 0.5);
    EXPECT_EQ(event.at("moved").at("before"), "0x1p+0");
    EXPECT_EQ(event.at("moved").at("after"), "0x1p-1");
    EXPECT_EQ(interrupted(), 1);
}

TEST_F(watch_verb, runs_nothing_for_a_comment_or_a_name) {
    watch({"smsr/case_09", "--no-times"});
    const std::string right = text(case_09_);
    save(case_09_, "// Nothing but words.\n" + right);
    Json event = next("same_code");
    EXPECT_EQ(event.at("kernel"), "smsr/case_09");
    EXPECT_EQ(event.at("good"), true);
    EXPECT_TRUE(passed_.empty());
    EXPECT_EQ(next("settled").at("checked"), 0);
    std::string renamed = right;
    for (std::size_t at = renamed.find("along_x"); at != renamed.npos; at = renamed.find("along_x"))
        renamed.replace(at, 7, "share");
    replace(case_09_, renamed);
    event = next("same_code");
    EXPECT_EQ(event.at("edit"), 2);
    EXPECT_TRUE(std::ranges::none_of(passed_, [](const Json& e) { return e.at("event") == "verdict"; }));
    save(case_09_, changed(right, "0.0 : 1.0", "1.0 : 0.0")); // what stays the same is not all there is
    EXPECT_EQ(next("verdict").at("good"), false);
}

TEST_F(watch_verb, checks_again_exactly_those_that_include_what_changed) {
    const std::string file = "conservative/lines.glslh";
    const watch::FolderTexts texts(kernels_);
    std::set<std::string> users;
    for (const Case* c : find_cases("conservative"))
        if (texts.of(*c).files.contains(file)) users.insert(c->name);
    ASSERT_GE(users.size(), 2u);
    ASSERT_LT(users.size(), find_cases("conservative").size());
    watch({"conservative", "--no-times", "--samples", "4096"});
    replace(file, text(file) + "float not_called_by_anybody(float x) { return x + 1.0; }\n");
    next("settled");
    std::set<std::string> told;
    for (const Json& event : passed_) {
        EXPECT_EQ(event.at("edit"), 1);
        EXPECT_TRUE(told.insert(event.at("kernel")).second) << "told twice";
    }
    EXPECT_EQ(told, users);
    EXPECT_EQ(interrupted(), 0);
}

TEST_F(watch_verb, shows_compile_errors_on_the_authors_line_and_goes_on) {
    watch({"smsr/case_0[19]", "--no-times"});
    const std::string right = text(case_09_);
    save(case_09_, changed(right, "0.0 : 1.0;", "0.0 : ;"));
    Json event = next("verdict");
    EXPECT_EQ(event.at("verdict"), "compile error");
    EXPECT_THAT(event.at("message"), StartsWith("kernels/smsr/case_09.glsl:4: "));
    EXPECT_EQ(next("settled").at("bad"), 1);
    save(case_09_, right);
    event = next("verdict");
    EXPECT_EQ(event.at("good"), true) << "the code is that of the last state that ran, the verdict is not";
    EXPECT_EQ(event.at("moved").at("samples"), 0);
    save(case_09_, changed(right, "float smsr", "#include \"nowhere/to.glslh\"\nfloat smsr"));
    event = next("verdict");
    EXPECT_THAT(event.at("message"), HasSubstr("cannot include \"nowhere/to.glslh\""));
    fs::create_directories(kernels_ / "nowhere"); // an include that comes later, in a folder that is new
    save("nowhere/to.glslh", "// Here.\n");
    EXPECT_EQ(next("verdict").at("good"), true);
    EXPECT_EQ(interrupted(), 0);
}

TEST_F(watch_verb, outlives_a_kernel_that_does_not_end) {
    watch({"smsr/case_0[13]", "--no-times", "--time-limit", "1"});
    const std::string right = text("smsr/case_01.glsl");
    const std::string endless =
        read_file(testing::source_folder() / "tests/kernels_that_fail/endless/smsr/case_01.glsl");
    save("smsr/case_01.glsl", endless);
    Json event = next("verdict");
    EXPECT_EQ(event.at("kernel"), "smsr/case_01");
    EXPECT_EQ(event.at("verdict"), "timeout");
    EXPECT_THAT(event.at("message"), HasSubstr("did not end within"));
    save("smsr/case_01.glsl", right);
    event = next("verdict");
    EXPECT_EQ(event.at("good"), true);
    save("smsr/case_03.glsl", changed(text("smsr/case_03.glsl"), "return", "return 2.0 +"));
    event = next("verdict");
    EXPECT_EQ(event.at("kernel"), "smsr/case_03");
    EXPECT_EQ(event.at("good"), false);
}

TEST_F(watch_verb, lets_a_newer_save_override_a_kernel_that_does_not_end) {
    watch({"smsr/case_01", "--no-times", "--time-limit", "1000"});
    const std::string right = text("smsr/case_01.glsl");
    save("smsr/case_01.glsl",
         read_file(testing::source_folder() / "tests/kernels_that_fail/endless/smsr/case_01.glsl"));
    std::this_thread::sleep_for(std::chrono::milliseconds(300)); // so that it has begun
    save("smsr/case_01.glsl", changed(right, "return 1.0", "return 1.0 + 0.0 * p.x"));
    const Json event = next("verdict");
    EXPECT_NE(event.at("verdict"), "timeout");
    EXPECT_EQ(event.at("edit"), 2);
}

TEST_F(watch_verb, outlives_a_crash_and_says_of_which_kernel) {
    watch({"smsr/case_0[23]", "--no-times"});
    const std::string right = text("smsr/case_02.glsl");
    // A sum so long that the compiler's recursion runs out of stack.
    std::string deep = "// Deep.\nfloat smsr_case_02(vec2 p) {\n    return p.x";
    for (int i = 0; i < 200000; ++i) deep += "+p.x";
    replace("smsr/case_02.glsl", deep + ";\n}\n");
    Json event = next("verdict");
    EXPECT_EQ(event.at("kernel"), "smsr/case_02");
    EXPECT_EQ(event.at("verdict"), "crash");
    EXPECT_THAT(event.at("message"), HasSubstr("signal 11"));
    EXPECT_EQ(next("settled").at("bad"), 1);
    replace("smsr/case_02.glsl", changed(right, "return 0.0", "return p.x * 0.0"));
    event = next("verdict");
    EXPECT_EQ(event.at("kernel"), "smsr/case_02");
    EXPECT_TRUE(event.contains("moved")) << "compared with the state before the crash";
}

TEST_F(watch_verb, notices_files_and_folders_that_vanish_and_come_back) {
    watch({"smsr/case_0[19]", "--no-times"});
    const std::string right = text(case_09_);
    fs::remove(kernels_ / case_09_);
    Json event = next("verdict");
    EXPECT_EQ(event.at("verdict"), "compile error");
    EXPECT_THAT(event.at("message"), HasSubstr("smsr/case_09.glsl: no such file"));
    next("settled");
    save(case_09_, right);
    EXPECT_EQ(next("verdict").at("good"), true);
    next("settled");
    fs::rename(kernels_ / "smsr", kernels_ / "elsewhere");
    EXPECT_EQ(next("settled").at("bad"), 2);
    fs::rename(kernels_ / "elsewhere", kernels_ / "smsr");
    EXPECT_EQ(next("settled").at("bad"), 0);
    fs::rename(kernels_, folder_.path() / "aside"); // all of it, as changing a branch may
    EXPECT_EQ(next("settled").at("bad"), 2);
    fs::rename(folder_.path() / "aside", kernels_);
    EXPECT_EQ(next("settled").at("bad"), 0);
    save(case_09_, changed(right, "0.0 : 1.0", "1.0 : 0.0"));
    EXPECT_EQ(next("verdict").at("good"), false) << "it still listens";
}

TEST_F(watch_verb, polls_where_it_is_told_to) {
    watch({"smsr/case_09", "--no-times", "--poll", "--jobs", "1"});
    const std::string right = text(case_09_);
    replace(case_09_, changed(right, "0.0 : 1.0", "1.0 : 0.0"));
    EXPECT_EQ(next("verdict").at("good"), false);
    fs::remove(kernels_ / case_09_);
    EXPECT_EQ(next("verdict").at("verdict"), "compile error");
    EXPECT_EQ(interrupted(), 1);
}

TEST_F(watch_verb, prints_plain_lines_into_a_pipe_and_ends_after_so_many_edits) {
    running_ = std::make_unique<Running>(arguments({"smsr/case_09", "--edits", "2"}));
    const std::string right = text(case_09_);
    std::vector<std::string> lines;
    std::size_t edits = 0;
    while (const std::optional<std::string> line = running_->line()) {
        lines.push_back(*line);
        EXPECT_THAT(*line, Not(HasSubstr("\x1b")));
        if (line->starts_with("1 checked")) save(case_09_, changed(right, "0.0 : 1.0", "1.0 : 0.0"));
        if (line->find("ns per evaluation") != line->npos && edits++ == 0)
            save(case_09_, changed(right, "1.0 - p.y < along_x", "1.0 < along_x + p.y"));
    }
    const std::string all = fmt::format("{}", fmt::join(lines, "\n"));
    EXPECT_THAT(all, StartsWith("watching 1 kernel below "));
    EXPECT_THAT(
        all, HasSubstr("FAIL (wrong); worst error 1.49e-08 -> none finite, allowed input within 5.96e-08; "));
    EXPECT_THAT(all, HasSubstr("\n  most at smsr_case_09(p = vec2("));
    EXPECT_THAT(all, HasSubstr("\n  gnomon eval smsr/case_09 --kernels "));
    EXPECT_THAT(all, HasSubstr("pass; worst error none finite -> "));
    EXPECT_EQ(edits, 2u);
    EXPECT_THAT(all, HasSubstr("\nended; all 1 kernels are good"));
    EXPECT_EQ(running_->exit_code(), 0);
}

TEST_F(watch_verb, begins_with_what_is_wrong_already) {
    const BrokenKernels broken("flipped_comparison");
    running_ = std::make_unique<Running>(Arguments{"watch", "smsr/case_09", "--format", "json", "--kernels",
                                                   broken.folder().string(), "--no-times"});
    const Json event = next("verdict");
    EXPECT_EQ(event.at("edit"), 0);
    EXPECT_EQ(event.at("good"), false);
    EXPECT_FALSE(event.contains("moved"));
    EXPECT_EQ(next("settled").at("bad"), 1);
    EXPECT_EQ(interrupted(), 1);
}

TEST_F(watch_verb, refuses_what_it_cannot_do_with_one_line) {
    const auto refused = [&](const Arguments& more, const std::string& what) {
        using testing::operator+;
        testing::expect_refused(folder_, Arguments{"watch"} + more, what);
    };
    refused({"nothing_like_this"}, "nothing_like_this");
    refused({"smsr", "--kernels", "/nowhere"}, "/nowhere");
    refused({"smsr", "--samples", "0"}, "--samples");
    refused({"smsr", "--samples", "10000000"}, "--samples");
    refused({"smsr", "--edits", "0"}, "--edits");
    refused({"smsr", "--seed", "x"}, "x");
    refused({"smsr", "--format", "xml"}, "--format");
    const fs::path regressions = folder_.path() / "regressions";
    fs::create_directories(regressions);
    write_file(regressions / "a.json", "{");
    refused({"smsr", "--regressions", regressions.string()}, "a.json: not JSON");
}

TEST_F(watch_verb, has_a_device_or_says_that_there_is_none) {
    const testing::Ran ran = testing::run_gnomon(arguments({"smsr/case_09", "--device", "no such device"}));
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("no device is called \"no such device\""));
}

} // namespace
} // namespace gnomon
