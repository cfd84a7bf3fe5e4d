// Which mutants a text has, written out by hand, and that they are known again when other things change.
#include "casegen/mutate/operators.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gnomon::mutate {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

/// "constant 1.0 -> 2.0", of one operator or of all.
std::vector<std::string> changes(std::string_view text, const char* by = nullptr) {
    std::vector<std::string> all;
    for (const Mutation& m : mutations(text))
        if (!by || std::string_view(to_string(m.by)) == by)
            all.push_back(fmt::format("{}{} -> {}", by ? "" : fmt::format("{} ", to_string(m.by)),
                                      text.substr(m.begin, m.end - m.begin), m.after));
    return all;
}

TEST(mutations, of_a_small_kernel_are_these_and_no_others) {
    EXPECT_THAT(changes("float f(vec2 p, float a) { return p.y < a ? 0.0 : -a; }"),
                UnorderedElementsAre("condition p.y < a -> false", "condition p.y < a -> true",
                                     "condition 0.0 : -a -> (-a) : (0.0)", "result p.y < a ? 0.0 : -a -> 0.0",
                                     "result p.y < a ? 0.0 : -a -> 1.0", "component y -> x",
                                     "comparison < -> <=", "comparison < -> >", "constant 0.0 -> 1.0",
                                     "constant 0.0 -> (-1.0)", "sign - -> "));
}

TEST(mutations, of_numbers_are_their_neighbours_and_multiples) {
    EXPECT_THAT(changes("int f() { int a = 7; return a; }", "constant"),
                ElementsAre("7 -> 8", "7 -> 6", "7 -> 14", "7 -> 3"));
    EXPECT_THAT(changes("uint f() { uint a = 0u; return a; }", "constant"), ElementsAre("0u -> 1u"));
    EXPECT_THAT(changes("uint f() { uint a = 0x10u; return a; }", "constant"),
                ElementsAre("0x10u -> 17u", "0x10u -> 15u", "0x10u -> 32u", "0x10u -> 8u"));
    EXPECT_THAT(changes("float f() { float a = 0.125; return a; }", "constant"),
                ElementsAre("0.125 -> 0.25", "0.125 -> 0.0625", "0.125 -> 0.12625"));
    EXPECT_THAT(changes("float f() { float a = 1e-3; return a; }", "constant"),
                ElementsAre("1e-3 -> 0.002", "1e-3 -> 0.0005", "1e-3 -> 0.00101"));
    EXPECT_THAT(changes("bool f() { bool a = true; return a; }", "constant"), ElementsAre("true -> false"));
}

TEST(mutations, of_operators_tell_a_sign_from_a_difference) {
    EXPECT_THAT(changes("float f(float a) { float b = a - -a; return b; }", "sign"),
                ElementsAre("a - -a -> -(a - -a)", "- -> ", "b -> -(b)"));
    EXPECT_THAT(changes("float f(float a) { float b = a - -a; return b; }", "arithmetic"),
                ElementsAre("- -> +"));
    EXPECT_THAT(changes("uint f(uint a) { a |= a << 1u; return a & ~a; }", "bits"),
                ElementsAre("|= -> &=", "<< -> >>", "& -> |"));
    EXPECT_THAT(changes("bool f(bool a, bool b) { return !a && b; }", "logic"),
                ElementsAre("! -> ", "&& -> ||"));
}

TEST(mutations, of_conditions_negate_take_and_leave_them) {
    const std::string_view text = "float f(float a) {\n    if (a < 1.0 && a > 0.0) a = 2.0;\n"
                                  "    for (int i = 0; i < 3; ++i) a += a;\n    if (a == 1.0) return 3.0;\n"
                                  "    return a;\n}\n";
    EXPECT_THAT(changes(text, "condition"),
                ElementsAre("a < 1.0 && a > 0.0 -> !(a < 1.0 && a > 0.0)", "a < 1.0 && a > 0.0 -> false",
                            "a < 1.0 && a > 0.0 -> true", "i < 3 -> !(i < 3)", "i < 3 -> false",
                            "a == 1.0 -> false", "a == 1.0 -> true"));
    EXPECT_THAT(changes(text, "comparison"), Contains("== -> !=")) << "which negates the last one";
    EXPECT_THAT(changes(text, "statement"), ElementsAre("a = 2.0; -> ;", "a += a; -> ;", "return 3.0; -> ;"));
}

TEST(mutations, of_a_loop_leave_it_an_end) {
    const auto of = [](const char* step) {
        return changes(fmt::format("int f(int a) {{ for (int i = 0; i < 9; {}) ++a; return a; }}", step),
                       "arithmetic");
    };
    EXPECT_THAT(of("++i"), ElementsAre("++i -> i += 2", "++ -> --"));
    EXPECT_THAT(of("i++"), ElementsAre("i++ -> i += 2", "++ -> --"));
    EXPECT_THAT(of("--i"), ElementsAre("--i -> i -= 2", "++ -> --"));
    EXPECT_THAT(of("++i, a++"), ElementsAre("++i -> i += 2", "a++ -> a += 2", "++ -> --"));
    EXPECT_THAT(of("i += 2"), ElementsAre("++ -> --"));
    EXPECT_THAT(of(""), ElementsAre("++ -> --"));
}

TEST(mutations, of_nested_choices_exchange_the_right_arms) {
    const std::string_view text = "float f(bool a, bool b) { return a ? b ? 1.0 : 2.0 : b ? 3.0 : 4.0; }";
    EXPECT_THAT(changes(text, "condition"),
                UnorderedElementsAre("a -> false", "a -> true", "b -> false", "b -> true", "b -> false",
                                     "b -> true",
                                     "b ? 1.0 : 2.0 : b ? 3.0 : 4.0 -> (b ? 3.0 : 4.0) : (b ? 1.0 : 2.0)",
                                     "1.0 : 2.0 -> (2.0) : (1.0)", "3.0 : 4.0 -> (4.0) : (3.0)"));
}

TEST(mutations, of_calls_drop_rename_and_turn_them_round) {
    const std::string_view text =
        "float f(float a, float b) { return clamp(min(a, b), 0.0, mix(a, b, 0.5)); }";
    EXPECT_THAT(
        changes(text, "call"),
        UnorderedElementsAre("clamp(min(a, b), 0.0, mix(a, b, 0.5)) -> (min(a, b))",
                             "clamp(min(a, b), 0.0, mix(a, b, 0.5)) -> max(min(a, b), 0.0)",
                             "clamp(min(a, b), 0.0, mix(a, b, 0.5)) -> min(min(a, b), mix(a, b, 0.5))",
                             "min -> max", "min(a, b) -> (a)", "min(a, b) -> (b)"));
    EXPECT_THAT(changes(text, "arguments"), UnorderedElementsAre("0.0, mix(a, b, 0.5) -> mix(a, b, 0.5), 0.0",
                                                                 "a, b -> b, a", "b, 0.5 -> 0.5, b"));
}

TEST(mutations, of_components_take_others) {
    EXPECT_THAT(changes("float f(vec4 v) { return v.x + v.w + dot(v.xy, v.zw) + v.xyz.z; }", "component"),
                UnorderedElementsAre("x -> y", "w -> z", "xy -> yx", "xy -> zw", "zw -> wz", "zw -> xy",
                                     "xyz -> zyx", "z -> x"));
}

TEST(mutations, leave_declarations_comments_and_directives_alone) {
    EXPECT_THAT(changes("#include \"smsr/case_09.glsl\"\n// 1.0 < 2.0\nbool lit(ivec2 texel);\n"
                        "struct S { vec2 a[2]; };\nfloat f(float a[3]);\n"),
                IsEmpty());
    EXPECT_THAT(
        changes("const uint BOTH = 3u; // both\n"),
        ElementsAre("constant 3u -> 4u", "constant 3u -> 2u", "constant 3u -> 6u", "constant 3u -> 1u"));
}

TEST(mutations, never_give_the_text_itself_nor_one_text_twice) {
    const std::string text =
        "float f(float a) { return min(a, a) * 1.0; }\nbool g(bool a) { return !(!a); }\n";
    std::set<std::string> texts{text};
    for (const Mutation& m : mutations(text)) EXPECT_TRUE(texts.insert(mutated(text, m)).second) << m.after;
    EXPECT_GT(texts.size(), 10u);
}

TEST(mutations, survive_texts_that_are_no_glsl) {
    for (const std::string_view text :
         {"float f() { return (1.0 ? ; }", "float f( { ? : }", "float f() { if (a ", "= ? : )",
          "float f() { return a ? b[ : c; }", "for (;;", "?"})
        for (const Mutation& m : mutations(text)) EXPECT_LE(m.end, text.size());
}

std::vector<std::string> identities(std::string_view text) {
    std::vector<std::string> all;
    for (const Mutation& m : mutations(text)) all.push_back(m.identity);
    return all;
}

TEST(identities, outlive_edits_elsewhere_but_not_edits_of_the_function) {
    const std::string f = "float f(float a) { return a < 1.0 ? 2.0 : a; }\n";
    const std::vector<std::string> before = identities(f);
    ASSERT_FALSE(before.empty());
    EXPECT_EQ(std::set<std::string>(before.begin(), before.end()).size(), before.size());
    const std::vector<std::string> after = identities("// New.\nconst float c = 3.0;\nfloat g(float a) { "
                                                      "return -a; }\n\n// Says more.\nfloat f(float a) {\n"
                                                      "    return a < 1.0 // near\n        ? 2.0 : a;\n}\n");
    for (const std::string& identity : before) EXPECT_THAT(after, Contains(identity));
    for (const std::string& identity : identities("float f(float b) { return b < 1.0 ? 2.0 : b; }\n"))
        EXPECT_THAT(before, Not(Contains(identity)));
}

TEST(stale_versions, answer_something_else_everywhere) {
    EXPECT_EQ(
        stale_version("float f(float a) { if (a < 0.0) return 0.0; return a; }\nfloat g() { return 1.0; }",
                      "f"),
        "float f(float a) { if (a < 0.0) return 1.0 - (0.0); return 1.0 - (a); }\nfloat g() { return 1.0; }");
    EXPECT_EQ(stale_version("ivec2 f() { return ivec2(3); }", "f"), "ivec2 f() { return ~(ivec2(3)); }");
    EXPECT_EQ(stale_version("float f() { return 1.0; }", "g"), "");
    EXPECT_EQ(stale_version("Edge f(int a) { return Edge(a); }", "f"), "");
}

TEST(operators, are_known_by_name) {
    for (const Operator by : all_operators()) EXPECT_EQ(parse_operator(to_string(by)), by);
    EXPECT_THROW(parse_operator("constants"), Error);
}

} // namespace
} // namespace gnomon::mutate
