// The atlas in Chromium, from file://: everything on it is seen, and search and filters do what they say.
// Without a browser these tests fail: whoever asks for them wants to know.
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/environment.h"

#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace gnomon {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Visit {
    std::vector<std::string> problems; ///< what atlas_page_test.js says
    std::vector<std::string> console;  ///< errors and warnings
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

const std::string& atlas() {
    static const std::string page = [] {
        const testing::TemporaryFolder folder;
        testing::run_well({"atlas", folder.path(), "--samples", "1024", "--coverage"});
        return read_file(folder.path() / "index.html");
    }();
    return page;
}

Visit visit(const std::string& page, const char* window = "1280,900") {
    const testing::TemporaryFolder folder;
    const std::string script = read_file(testing::source_folder() / "tests/ci/atlas_page_test.js");
    const std::filesystem::path path =
        folder.write("index.html", page + "<script>\n" + script + "</script>\n");
    const testing::Ran ran = testing::run_shell(
        fmt::format("exec chromium --headless --no-sandbox --disable-gpu --no-first-run --user-data-dir='{}' "
                    "--window-size={} "
                    "--enable-logging=stderr --virtual-time-budget=20000 --dump-dom 'file://{}'",
                    (folder.path() / "profile").string(), window, path.string()));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_FALSE(ran.timed_out);
    Visit result;
    for (const std::string& line : lines_of(ran.err))
        if (line.find("CONSOLE") != line.npos) result.console.push_back(line);
    const std::string begin = "<pre id=\"report\">";
    const std::size_t at = ran.out.find(begin);
    EXPECT_NE(at, ran.out.npos) << "the page's tests did not come to their end\n" << ran.err;
    if (at == ran.out.npos) return result;
    const std::size_t from = at + begin.size();
    result.problems = lines_of(ran.out.substr(from, ran.out.find("</pre>", from) - from));
    EXPECT_EQ(result.problems.at(0), "done");
    result.problems.erase(result.problems.begin());
    return result;
}

/// The atlas with something broken, which must be there to be broken.
std::string with(const std::string& from, const std::string& to, bool everywhere = false) {
    std::string page = atlas();
    std::size_t at = page.find(from);
    EXPECT_NE(at, page.npos) << from;
    for (; at != page.npos; at = everywhere ? page.find(from, at + to.size()) : page.npos)
        page.replace(at, from.size(), to);
    return page;
}

TEST(atlas_in_a_browser, is_whole_and_can_be_searched) {
    const Visit seen = visit(atlas());
    EXPECT_THAT(seen.problems, IsEmpty());
    EXPECT_THAT(seen.console, IsEmpty());
}

TEST(atlas_in_a_browser, fits_a_narrow_window) {
    EXPECT_THAT(visit(atlas(), "500,900").problems, IsEmpty()); // Chromium's narrowest
}

// That these tests can fail:

TEST(atlas_in_a_browser, a_broken_picture_is_noticed) {
    EXPECT_THAT(visit(with("data:image/png;base64,iVBOR", "data:image/png;base64,iVBOX")).problems,
                Contains(HasSubstr("a picture is broken")));
}

TEST(atlas_in_a_browser, an_error_in_the_script_is_noticed) {
    const Visit seen = visit(with("\"use strict\";", "\"use strict\"; no_such_function();"));
    EXPECT_THAT(seen.console, Contains(HasSubstr("no_such_function")));
    EXPECT_THAT(seen.problems, Contains(HasSubstr("filters are not shown")));
}

TEST(atlas_in_a_browser, a_warning_is_noticed) {
    EXPECT_THAT(visit(with("\"use strict\";", "\"use strict\"; console.warn('careful');")).console,
                Contains(HasSubstr("careful")));
}

TEST(atlas_in_a_browser, filters_that_do_not_filter_are_noticed) {
    const Visit seen = visit(with("entry.hidden = !fits", "entry.hidden = false"));
    EXPECT_THAT(seen.problems, Contains(HasSubstr("search: nonsense finds something")));
    EXPECT_THAT(seen.problems, Contains(HasSubstr("filter light = ")));
}

TEST(atlas_in_a_browser, unseen_formulas_are_noticed) {
    EXPECT_THAT(
        visit(with("<math displaystyle", "<math style=\"display: none\" displaystyle", true)).problems,
        Contains(HasSubstr("math without a size")));
}

} // namespace
} // namespace gnomon
