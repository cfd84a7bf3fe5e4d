#include "casegen/atlas/mathml.h"

#include "casegen/catalogue.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace gnomon::atlas {
namespace {

using gnomon::testing::error_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// What is within <math …><mrow>…</mrow></math>.
std::string inner(const std::string& formula) {
    std::string text = formula_to_mathml(formula);
    const std::string begin = "<math displaystyle=\"true\"><mrow>", end = "</mrow></math>";
    EXPECT_TRUE(text.starts_with(begin) && text.ends_with(end)) << text;
    return text.substr(begin.size(), text.size() - begin.size() - end.size());
}

/// Every element is closed, in the order in which it was opened.
bool well_formed(const std::string& xml) {
    std::vector<std::string> open;
    for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
        const std::size_t end = xml.find_first_of(" >", at);
        const std::string name = xml.substr(at + 1, end - at - 1);
        if (!name.starts_with('/')) {
            open.push_back(name);
        } else {
            if (open.empty() || "/" + open.back() != name) return false;
            open.pop_back();
        }
    }
    return open.empty();
}

TEST(formula_mathml, numbers_names_and_signs) {
    EXPECT_EQ(inner("1"), "<mn>1</mn>");
    EXPECT_EQ(inner("0.25"), "<mn>0.25</mn>");
    EXPECT_EQ(inner("q"), "<mi>q</mi>");
    EXPECT_EQ(inner("p.x"), "<msub><mi>p</mi><mrow><mi>x</mi></mrow></msub>");
    EXPECT_EQ(inner("a_1"), "<msub><mi>a</mi><mrow><mn>1</mn></mrow></msub>");
    EXPECT_EQ(inner("d_c.b"), "<msub><mi>d</mi><mrow><mi>c.b</mi></mrow></msub>");
    EXPECT_EQ(inner("n_-y"), "<msub><mi>n</mi><mrow><mo form=\"prefix\">−</mo><mi>y</mi></mrow></msub>");
    EXPECT_EQ(inner("BOTH"), "<mtext>BOTH</mtext>");
    EXPECT_EQ(inner("along_y"), "<msub><mi>d</mi><mrow><mi>on.g</mi></mrow></msub>");
    EXPECT_EQ(inner("1 + a - 2 * b"),
              "<mn>1</mn><mo>+</mo><mi>a</mi><mo>−</mo><mn>2</mn><mo>·</mo><mi>b</mi>");
    EXPECT_EQ(inner("-a"), "<mo form=\"prefix\">−</mo><mi>a</mi>");
    EXPECT_EQ(inner("a^2"), "<msup><mrow><mi>a</mi></mrow><mrow><mn>2</mn></mrow></msup>");
    EXPECT_EQ(inner("|a|"), "<mrow><mo form=\"prefix\">|</mo><mi>a</mi><mo form=\"postfix\">|</mo></mrow>");
}

TEST(formula_mathml, fractions_lose_parentheses_and_products_keep_them) {
    EXPECT_EQ(inner("(1 - a) / (b + c)"), "<mfrac><mrow><mn>1</mn><mo>−</mo><mi>a</mi></mrow>"
                                          "<mrow><mi>b</mi><mo>+</mo><mi>c</mi></mrow></mfrac>");
    EXPECT_EQ(inner("(a + b) * c"),
              "<mrow><mo>(</mo><mi>a</mi><mo>+</mo><mi>b</mi><mo>)</mo></mrow><mo>·</mo><mi>c</mi>");
}

TEST(formula_mathml, functions) {
    EXPECT_EQ(inner("min(a, 1)"), "<mrow><mi>min</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>a</mi>"
                                  "<mo separator=\"true\">,</mo><mn>1</mn><mo>)</mo></mrow></mrow>");
    EXPECT_TRUE(well_formed(inner("max(0, min(q_y, 1 + p.x - along_y))")));
}

TEST(formula_mathml, rows_stand_behind_a_brace) {
    EXPECT_EQ(
        inner("0 if a < b; 1 otherwise"),
        "<mo form=\"prefix\" stretchy=\"true\">{</mo><mtable>"
        "<mtr><mtd><mrow><mn>0</mn></mrow></mtd><mtd><mrow><mtext>if&#160;</mtext><mi>a</mi><mo>&lt;</mo>"
        "<mi>b</mi></mrow></mtd></mtr>"
        "<mtr><mtd><mrow><mn>1</mn></mrow></mtd><mtd><mrow><mtext>otherwise</mtext></mrow></mtd></mtr>"
        "</mtable>");
    EXPECT_THAT(inner("0 if a <= b and c > 1 or d != 2; 1 otherwise"),
                AllOf(HasSubstr("<mo>≤</mo>"), HasSubstr("<mo>∧</mo>"), HasSubstr("<mo>&gt;</mo>"),
                      HasSubstr("<mo>∨</mo>"), HasSubstr("<mo>≠</mo>")));
    EXPECT_THAT(inner("0 if lit and a = BOTH"), HasSubstr("<mi>lit</mi><mo>∧</mo><mi>a</mi><mo>=</mo>"));
    EXPECT_THAT(inner("0 if a < 1"), HasSubstr("<mtable>")); // one row, but a condition
}

TEST(formula_mathml, knows_which_names_are_in_it) {
    EXPECT_THAT(names_in("min(q_y, 1 - p.x) if n_-y = BOTH and lit; 1 otherwise"),
                ::testing::ElementsAre("BOTH", "lit", "n_-y", "p.x", "q_y"));
}

TEST(formula_mathml, names_what_does_not_belong) {
    EXPECT_THAT(
        error_of([] { formula_to_mathml("1 + p.x # 2"); }),
        AllOf(HasSubstr("\"1 + p.x # 2\""), HasSubstr("unknown character '#'"), HasSubstr("column 9")));
    EXPECT_THAT(error_of([] { formula_to_mathml("a − b"); }), HasSubstr("unknown character '−'"));
    EXPECT_THAT(error_of([] { formula_to_mathml("a\tb"); }), HasSubstr("byte 0x09"));
    EXPECT_THAT(error_of([] { formula_to_mathml("a b"); }), HasSubstr("\"b\" does not belong"));
    EXPECT_THAT(error_of([] { formula_to_mathml("a + * b"); }), HasSubstr("\"*\" does not belong"));
    EXPECT_THAT(error_of([] { formula_to_mathml("0 if"); }), HasSubstr("ends where"));
    EXPECT_THAT(error_of([] { formula_to_mathml("0 if 1"); }), HasSubstr("ends where"));
    EXPECT_THAT(error_of([] { formula_to_mathml("0 if a + b"); }), HasSubstr("ends where"));
    EXPECT_THAT(error_of([] { formula_to_mathml("min(a, b"); }), HasSubstr("ends where"));
    EXPECT_THAT(error_of([] { formula_to_mathml("(a"); }), HasSubstr("ends where"));
    EXPECT_THAT(error_of([] { formula_to_mathml("a)"); }), HasSubstr("\")\" does not belong"));
    EXPECT_THAT(error_of([] { formula_to_mathml("otherwise"); }), HasSubstr("\"otherwise\""));
    EXPECT_THAT(error_of([] { formula_to_mathml("1;"); }), HasSubstr("ends where"));
    EXPECT_THAT(error_of([] { formula_to_mathml(""); }), HasSubstr("ends where"));
}

TEST(formula_mathml, takes_every_formula_of_the_catalogue) {
    for (const Case* c : find_cases(""))
        if (!c->formula.empty()) EXPECT_TRUE(well_formed(formula_to_mathml(c->formula))) << c->name;
}

TEST(condition_mathml, prints_the_documents_numbers) {
    using namespace sets;
    const std::string run = condition_to_mathml({run_along_x(lit, plus, one_end)});
    EXPECT_THAT(run, HasSubstr("<msub><mi>s</mi><mi>c</mi></msub><mo>=</mo><mn>1</mn>"));
    EXPECT_THAT(run, HasSubstr("<mi>c.r</mi></msub><mo>=</mo><mn>0</mn>"));
    EXPECT_THAT(run, HasSubstr("<mi>c.g</mi></msub><mo>=</mo><mn>0.5</mn>"));
    EXPECT_THAT(run, HasSubstr("<mi>h</mi></msub><mo>=</mo><mn>0</mn>"));
    EXPECT_EQ(run.find("<mi>v</mi>"), run.npos); // of the other run nothing is asked
    // 0.25 is PLUS along x.
    EXPECT_THAT(condition_to_mathml({run_along_y(lit, plus, open)}),
                AllOf(HasSubstr("<mi>c.r</mi></msub><mo>=</mo><mn>0.25</mn>"), HasSubstr("−")));
}

TEST(condition_mathml, sets) {
    using namespace sets;
    EXPECT_THAT(
        condition_to_mathml({{.side_x = one}}),
        HasSubstr("<mo>∈</mo><mrow><mo>{</mo><mn>0.25</mn><mo separator=\"true\">,</mo><mn>0.5</mn>"));
    EXPECT_THAT(condition_to_mathml({{.side_y = some}}), HasSubstr("<mo>≠</mo><mn>0</mn>"));
    EXPECT_THAT(condition_to_mathml({{.type_x = 0}}), HasSubstr("∅"));
    EXPECT_THAT(condition_to_mathml({{}}), HasSubstr("always"));
}

TEST(condition_mathml, dominance_says_one_thing_for_each_set) {
    std::set<std::string> all;
    for (unsigned dominant = 0; dominant <= sets::any_dominance; ++dominant) {
        all.insert(condition_to_mathml({{.dominant = dominant}}));
    }
    EXPECT_EQ(all.size(), 16u);
    const std::string both = condition_to_mathml({{.dominant = sets::goes_on_both}});
    EXPECT_THAT(both, HasSubstr("<mi>r</mi></msub><mo>=</mo><mn>1</mn>"));
    EXPECT_THAT(both, HasSubstr("<mi>g</mi></msub><mo>=</mo><mn>1</mn>"));
}

TEST(condition_mathml, alternatives_have_a_row_each) {
    const std::string text = condition_to_mathml({{.light = 1}, {.light = 2}});
    EXPECT_TRUE(well_formed(text));
    EXPECT_THAT(text, HasSubstr("<mtr><mtd></mtd>"));
    EXPECT_THAT(text, HasSubstr("<mtr><mtd><mo>∨</mo></mtd>"));
    for (const Case* c : find_cases(""))
        if (!c->condition.empty()) EXPECT_TRUE(well_formed(condition_to_mathml(c->condition))) << c->name;
}

} // namespace
} // namespace gnomon::atlas
