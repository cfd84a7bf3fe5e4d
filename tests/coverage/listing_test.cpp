// A kernel's text in the atlas, with what was reached of it: in words, not by colour alone.
#include "casegen/atlas/listing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon::atlas {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Counters: 0 f, 1 what follows, 2 and 3 `x < 3`.
coverage::FileCoverage file(const std::vector<coverage::Hits>& hits) {
    coverage::FileCoverage file;
    file.name = "a/b.glsl";
    file.text = "int f(int x) {\n    if (x < 3)\n        return 1;\n    return 2;\n}\n";
    file.points = coverage::instrument(file.text);
    file.hits = hits;
    EXPECT_EQ(file.points.counters, hits.size());
    return file;
}

TEST(listing, says_of_every_line_and_outcome_how_often_it_was_reached) {
    const std::string html = listing_html(file({{5, 4}, {5, 0}, {0, 4}, {5, 0}}));
    EXPECT_THAT(html, HasSubstr("<td class=\"number\">9</td><td class=\"number soft\">1</td>"));
    EXPECT_THAT(html,
                HasSubstr("<code>x &lt; 3</code> true 4 <span class=\"soft\">random samples only</span>, "
                          "false 5</div>"));
    EXPECT_THAT(html, HasSubstr("<td class=\"number\"></td><td class=\"number soft\">5</td>")); // the brace
    EXPECT_THAT(html, Not(HasSubstr("never")));
}

TEST(listing, marks_what_was_never_reached_in_words) {
    const coverage::FileCoverage some = file({{5, 0}, {5, 0}, {0, 0}, {5, 0}});
    const std::string html = listing_html(some);
    EXPECT_THAT(html, HasSubstr("<tr class=\"missed\"><td class=\"number\"><b class=\"never\">never</b></td>"
                                "<td class=\"number soft\">3</td>"));
    EXPECT_THAT(html, HasSubstr("true <b class=\"never\">never</b>, false 5"));
    EXPECT_EQ(reached_in_words(some), "3 of 4 lines, 1 of 2 branches");
}

} // namespace
} // namespace gnomon::atlas
