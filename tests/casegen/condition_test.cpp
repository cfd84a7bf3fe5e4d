#include "casegen/condition.h"

#include <gtest/gtest.h>

#include <set>

namespace gnomon {
namespace {

using namespace sets;

TEST(condition_in_words, says_what_is_asked_and_nothing_else) {
    EXPECT_EQ(in_words(Condition{}), "a texel");
    EXPECT_EQ(in_words(run_along_x(lit, plus, one_end)),
              "a lit texel with shadow towards +y and none along x; the run along x ends once");
    EXPECT_EQ(
        in_words(run_along_y(shadowed, some, closed)),
        "a shadowed texel with light towards -x, +x or both and none along y; the run along y ends both "
        "ways");
    EXPECT_EQ(
        in_words(corner(lit, one, minus, one_end, any_type, goes_on_x | goes_on_both)),
        "a lit texel with shadow towards either -x or +x and towards -y; the run along x ends once; the x "
        "side's edge goes on beyond the corner");
    EXPECT_EQ(in_words(Condition{.light = lit, .side_x = neither, .side_y = neither}),
              "a lit texel with no shadow along x and none along y");
    EXPECT_EQ(in_words(Condition{.side_x = both}), "a texel with change towards both -x and +x");
}

TEST(condition_in_words, parts_alternatives) {
    EXPECT_EQ(in_words(Conditions{run_along_x(lit, plus, open), run_along_y(lit, plus, open)}),
              "a lit texel with shadow towards +y and none along x; the run along x is open; or a lit texel "
              "with shadow towards +x and none along y; the run along y is open");
}

TEST(condition_in_words, differs_wherever_the_condition_does) {
    std::set<std::string> words;
    std::size_t conditions = 0;
    for (unsigned light = 0; light <= 3; ++light)
        for (unsigned side = 0; side <= any_side; ++side)
            for (unsigned type = 0; type <= any_type; ++type)
                for (unsigned dominant = 0; dominant <= any_dominance; ++dominant) {
                    words.insert(in_words(
                        Condition{.light = light, .side_x = side, .type_y = type, .dominant = dominant}));
                    words.insert(in_words(
                        Condition{.light = light, .side_y = side, .type_x = type, .dominant = dominant}));
                    conditions += 2;
                }
    const std::size_t told_once_by_either = std::size_t{4} * (any_dominance + 1); // sides and types: all
    EXPECT_EQ(words.size(), conditions - told_once_by_either);
}

} // namespace
} // namespace gnomon
