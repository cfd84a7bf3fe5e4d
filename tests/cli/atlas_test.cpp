// gnomon atlas: the page as a text. What a browser makes of it is tested in tests/ci.
#include "casegen/witness.h"
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/broken_kernels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

namespace gnomon {
namespace {

using testing::Arguments;
using testing::expect_refused;
using ::testing::HasSubstr;
using testing::Ran;
using testing::run_well;
using testing::TemporaryFolder;

std::string page_of(const TemporaryFolder& folder, const Arguments& more = {}) {
    using testing::operator+;
    run_well(Arguments{"atlas", folder.path() / "new" / "atlas", "--samples", "256"} + more);
    return read_file(folder.path() / "new" / "atlas" / "index.html");
}

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
        found.push_back((*at)[1]);
    return found;
}

TEST(atlas, has_an_entry_for_every_numbered_case_and_a_row_for_every_other_kernel) {
    const TemporaryFolder folder;
    const std::string page = page_of(folder);
    EXPECT_EQ(folder.entries(), 1u);
    std::size_t numbered = 0;
    for (const Case* c : find_cases("")) {
        std::string id = c->name;
        std::ranges::replace(id, '/', '-');
        const std::string begin = c->number != 0 ? "<article class=\"case\" id=\"" : "<tr id=\"";
        EXPECT_THAT(page, HasSubstr(begin + id + "\"")) << c->name;
        if (c->number != 0) ++numbered;
    }
    EXPECT_EQ(all_matches(page, "(<article)").size(), numbered);
    // Kernel, reference, difference, and the technique over the witness.
    EXPECT_GE(all_matches(page, "(<img)").size(), 3 * numbered);
    EXPECT_EQ(all_matches(page, "(<figure class=\"witness\">)").size(), numbered);
    EXPECT_GE(all_matches(page, "(<svg class=\"mask\")").size(), numbered); // one for each way, too
    EXPECT_EQ(all_matches(page, "(class=\"trouble\")").size(), 0u);
}

TEST(atlas, shows_every_way_through_a_case_that_has_several) {
    const TemporaryFolder folder;
    std::map<std::string, std::size_t> ways;
    for (const Family& family : catalogue())
        for (const BranchWitness& found : branch_witnesses(family)) ++ways[found.branch.kernel->name];
    std::size_t shown = 0;
    for (const auto& [name, count] : ways)
        if (count > 1) shown += count;
    EXPECT_GT(shown, 100u);
    EXPECT_EQ(all_matches(page_of(folder), "(<div class=\"pair\"><svg class=\"mask\")").size(), shown);
}

// A picture of one colour says little: only cases that have one value may show it.
TEST(atlas, shows_where_a_case_s_value_varies) {
    const TemporaryFolder folder;
    const std::vector<std::string> constant =
        all_matches(page_of(folder), "id=\"([^\"]*)\"[^>]*data-kind=\"constant\"");
    EXPECT_THAT(constant, ::testing::UnorderedElementsAre("smsr-case_01", "smsr-case_02", "smsr-case_03",
                                                          "rsmss-case_01", "rsmss-case_02", "rsmss-case_03",
                                                          "rbsm-silhouette-i", "rbsm-silhouette-u",
                                                          "rbsm-silhouette-o", "rbsm-filter-i",
                                                          "rbsm-filter-short_o", "rbsm-filter-long_o"));
}

TEST(atlas, needs_nothing_but_itself) {
    const TemporaryFolder folder;
    const std::string page = page_of(folder);
    std::set<std::string> ids;
    for (const std::string& id : all_matches(page, " id=\"([^\"]*)\""))
        EXPECT_TRUE(ids.insert(id).second) << id << " names two elements";
    for (const std::string& target : all_matches(page, "(?:src|href)=\"([^\"]{0,80})")) {
        if (target.starts_with('#'))
            EXPECT_TRUE(ids.contains(target.substr(1))) << target;
        else
            EXPECT_TRUE(target.starts_with("data:")) << target;
    }
    const std::string sources = testing::source_folder().string();
    for (const std::string& part :
         {std::string("http:"), std::string("https:"), std::string("@import"), std::string("url(h"),
          std::string("/tmp/"), std::string("/home/"), sources})
        EXPECT_EQ(page.find(part), page.npos) << part;
    EXPECT_LT(page.size(), 5u << 20);
    // Without a script there are no filters, and nothing is hidden.
    EXPECT_THAT(page, HasSubstr("<form id=\"filters\" role=\"search\" hidden>"));
    EXPECT_EQ(all_matches(page, "(<(?:article|section|figure|details)[^>]* hidden)").size(), 0u);
}

TEST(atlas, is_the_same_again_but_for_times) {
    const TemporaryFolder first, second;
    const std::regex times("<span class=\"time\">[^<]*</span>");
    EXPECT_EQ(std::regex_replace(page_of(first, {"--jobs", "1"}), times, ""),
              std::regex_replace(page_of(second, {"--jobs", "2"}), times, ""));
}

TEST(atlas, shows_a_census) {
    const TemporaryFolder folder;
    const std::string census = folder.write("lattice.json", R"({"smsr": {"9": 0.12345}})");
    const std::string page = page_of(folder, {"--census", census});
    EXPECT_THAT(page, HasSubstr("Share, lattice"));
    EXPECT_THAT(page, HasSubstr("12.35 %")); // 0.12345 is a little more in binary
}

struct Broken {
    const char *folder, *id, *message;
};
class atlas_of_broken_kernels : public ::testing::TestWithParam<Broken> {};

TEST_P(atlas_of_broken_kernels, is_written_and_says_so) {
    const testing::BrokenKernels kernels(GetParam().folder);
    const TemporaryFolder folder;
    const Ran ran =
        testing::run_gnomon({"atlas", folder.path(), "--samples", "256", "--kernels", kernels.folder()});
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    const std::string page = read_file(folder.path() / "index.html");
    const std::size_t begin = page.find(std::string("<article class=\"case\" id=\"") + GetParam().id);
    ASSERT_NE(begin, page.npos);
    const std::string entry = page.substr(begin, page.find("</article>", begin) - begin);
    EXPECT_THAT(entry, HasSubstr("data-verdict=\"fail\""));
    EXPECT_THAT(entry, HasSubstr("class=\"trouble"));
    EXPECT_THAT(entry, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(kernels_that_fail, atlas_of_broken_kernels,
                         ::testing::Values(Broken{"syntax_error", "smsr-case_09", "smsr/case_09.glsl:"},
                                           Broken{"wrong_constant", "smsr-case_02",
                                                  "gnomon eval smsr/case_02"},
                                           Broken{"never_written", "smsr-case_01", "never written"}));

TEST(atlas, refuses_a_folder_that_cannot_be) {
    const TemporaryFolder folder;
    expect_refused(folder, {"atlas"}, "OUT_DIR");
    expect_refused(folder, {"atlas", folder.write("file", "")}, "file");
    expect_refused(folder, {"atlas", folder.path() / "file" / "below"}, "below");
    expect_refused(folder, {"atlas", ""}, "OUT_DIR: is empty");
    std::filesystem::create_directories(folder.path() / "taken" / "index.html");
    expect_refused(folder, {"atlas", folder.path() / "taken"}, "index.html");
    expect_refused(folder, {"atlas", "/proc/atlas"}, "/proc/atlas");
    // Nothing is made for an atlas that cannot be.
    expect_refused(folder, {"atlas", folder.path() / "never", "--device", "no such device"},
                   "no such device");
    expect_refused(folder, {"atlas", folder.path() / "never", "--kernels", folder.path() / "none"}, "none");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "never"));
}

TEST(atlas, refuses_bad_options_and_leaves_no_page) {
    const TemporaryFolder folder;
    const std::string out = folder.path() / "out";
    for (const auto& [arguments, what] : std::vector<std::pair<Arguments, std::string>>{
             {{"--samples", "0"}, "--samples"}, {{"--seed", "seven"}, "--seed"}}) {
        using testing::operator+;
        expect_refused(folder, Arguments{"atlas", out} + arguments, what); // not even the folder
    }
    std::filesystem::create_directories(out);
    for (const auto& [arguments, what] : std::vector<std::pair<Arguments, std::string>>{
             {{"--census", folder.path() / "none.json"}, "none.json"},
             {{"--kernels", folder.path() / "none"}, "none"}}) {
        using testing::operator+;
        expect_refused(folder, Arguments{"atlas", out} + arguments, what);
        EXPECT_TRUE(std::filesystem::is_empty(out)) << what;
    }
}

} // namespace
} // namespace gnomon
