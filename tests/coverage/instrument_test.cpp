// Where counters go in a text, to the letter; and what of a text bears none.
#include "casegen/coverage/instrument.h"

#include "runtime/files.h"
#include "tests/support/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gnomon::coverage {
namespace {

using ::testing::ElementsAre;

std::string text_of(std::string_view text) { return instrument(text).text; }

std::vector<std::string> branches(const Instrumented& instrumented) {
    std::vector<std::string> all;
    for (const Branch& branch : instrumented.branches) {
        std::string line = std::to_string(branch.line) + ": " + branch.text;
        for (const Branch::Outcome& outcome : branch.outcomes)
            line += ", " + outcome.what + " " + std::to_string(outcome.counter);
        all.push_back(line);
    }
    return all;
}

TEST(instrument, a_function_is_counted_where_it_begins_and_so_are_the_statements_that_follow) {
    EXPECT_EQ(text_of("float f(float x) {\n    float y = x;\n    y += 1.0;\n    return y;\n}\n"),
              "float f(float x) { gnomon_hit(0u);\n    float y = x;\n    y += 1.0;\n    return y;\n}\n");
}

TEST(instrument, an_if_without_else_has_two_outcomes_and_what_follows_a_return_is_counted_anew) {
    const Instrumented done = instrument("int f(int x) {\n  if (x < 3) return 1;\n  return 2;\n}");
    EXPECT_EQ(done.text, "int f(int x) { gnomon_hit(0u);\n  if (gnomon_was(2u, x < 3)) return 1;\n"
                         "  gnomon_hit(1u); return 2;\n}");
    EXPECT_THAT(branches(done), ElementsAre("2: x < 3, true 2, false 3"));
    EXPECT_EQ(done.counters, 4u);
}

TEST(instrument, bodies_without_braces_get_them_where_no_outcome_counts_them) {
    EXPECT_EQ(
        text_of("void f() { if (a && !b) x = 1; else if (c) x = 2; else x = 3; y = 4; }"),
        "void f() { gnomon_hit(0u); if (gnomon_was(2u, a) && gnomon_was(4u, !b)) { gnomon_hit(1u); x = 1; }"
        " else { gnomon_hit(6u); if (gnomon_was(8u, c)) x = 2; else x = 3; } y = 4; }");
}

TEST(instrument, operands_of_and_and_or_are_conditions_wherever_they_stand) {
    const Instrumented done = instrument("bool f() { return (a || b < c) && !(d && e); }");
    EXPECT_EQ(done.text, "bool f() { gnomon_hit(0u); return (gnomon_was(2u, a) || gnomon_was(4u, b < c)) && "
                         "!(gnomon_was(6u, d) && gnomon_was(8u, e)); }");
    EXPECT_THAT(branches(done), ElementsAre("1: a, true 2, false 3", "1: b < c, true 4, false 5",
                                            "1: d, true 6, false 7", "1: e, true 8, false 9"));
}

TEST(instrument, a_choice_is_counted_by_its_condition_and_nests) {
    EXPECT_EQ(text_of("int f() { return a ? b ? 1 : 2 : c == 0 ? 3 : g(d ? 4 : 5); }"),
              "int f() { gnomon_hit(0u); return gnomon_was(2u, a) ? gnomon_was(4u, b) ? 1 : 2 : "
              "gnomon_was(6u, c == 0) ? 3 : g(gnomon_was(8u, d) ? 4 : 5); }");
}

TEST(instrument, the_right_hand_side_of_an_assignment_holds_the_condition) {
    EXPECT_EQ(text_of("void f() { x[a ? 1 : 0] = b ? 2 : 3; precise float y = c ? 1.0 : 2.0, z = 3.0; }"),
              "void f() { gnomon_hit(0u); x[gnomon_was(2u, a) ? 1 : 0] = gnomon_was(4u, b) ? 2 : 3; "
              "precise float y = gnomon_was(6u, c) ? 1.0 : 2.0, z = 3.0; }");
}

TEST(instrument, loops_are_entered_and_left_by_their_condition) {
    EXPECT_EQ(
        text_of("void f() {\n for (int i = a ? 1 : 0; i < n; ++i)\n  for (;;) { if (b) break; c(); }\n"
                " while (d || e) g();\n do { h(); } while (k);\n}"),
        "void f() { gnomon_hit(0u);\n for (int i = gnomon_was(2u, a) ? 1 : 0; gnomon_was(4u, i < n); ++i)\n"
        "  for (;;) { gnomon_hit(1u); if (gnomon_was(6u, b)) break; gnomon_hit(8u); c(); }\n"
        " gnomon_hit(9u); while (gnomon_was(10u, d) || gnomon_was(12u, e)) { gnomon_hit(14u); g(); }\n"
        " do { gnomon_hit(15u); h(); } while (gnomon_was(16u, k));\n}");
}

TEST(instrument, every_label_of_a_switch_is_an_outcome_and_so_is_none_of_them) {
    const Instrumented done = instrument(
        "int f(uint n) {\n switch (n) {\n case 1u: return 4;\n case 2u:\n case 3u: g(); break;\n }\n"
        " return 0;\n}");
    EXPECT_EQ(done.text,
              "int f(uint n) { gnomon_hit(0u);\n switch (n) {\n case 1u: gnomon_hit(1u); return 4;\n"
              " case 2u: gnomon_hit(2u);\n case 3u: gnomon_hit(3u); g(); break;\n"
              " break; default: gnomon_hit(4u); }\n gnomon_hit(5u); return 0;\n}");
    EXPECT_THAT(branches(done), ElementsAre("2: n, case 1u 1, case 2u 2, case 3u 3, none of them 4"));
}

TEST(instrument, a_switch_with_a_default_gets_no_other) {
    EXPECT_EQ(text_of("void f() { switch (n) { case 0: g(); break; default: h(); } }"),
              "void f() { gnomon_hit(0u); switch (n) { case 0: gnomon_hit(1u); g(); break; default: "
              "gnomon_hit(2u); "
              "h(); } }");
}

TEST(instrument, what_must_be_constant_is_left_alone_and_said) {
    const char* text =
        "const bool A = B && C;\nconst int N = A ? 1 : 2;\n#define PICK(a, b) ((a) ? (b) : 0)\n"
        "void f() {\n  const float x = A ? 1.0 : 2.0;\n  float y[A ? 1 : 2];\n"
        "  float z[2] = float[A ? 1 : 2](1.0, 2.0);\n}";
    const Instrumented done = instrument(text);
    EXPECT_TRUE(done.branches.empty());
    std::vector<int> lines;
    for (const Omission& omission : done.omissions) lines.push_back(omission.line);
    EXPECT_THAT(lines, ElementsAre(1, 3, 5, 6));
}

TEST(instrument, nothing_but_functions_is_counted) {
    const char* text =
        "#include \"a.glsl\" // b ? c : d\nstruct S { int a; };\nconst uint N = 3u;\nbool lit(ivec2 t);\n";
    const Instrumented done = instrument(text);
    EXPECT_EQ(done.text, text);
    EXPECT_EQ(done.counters, 0u);
    EXPECT_TRUE(done.omissions.empty());
}

TEST(instrument, a_text_that_the_preprocessor_chooses_from_is_left_alone_and_said) {
    const char* text = "#ifdef A\nvoid f() { if (a) b(); }\n#endif\n";
    const Instrumented done = instrument(text);
    EXPECT_EQ(done.text, text);
    ASSERT_EQ(done.omissions.size(), 1u);
    EXPECT_EQ(done.omissions[0].line, 1);
}

TEST(instrument, what_is_no_glsl_comes_back_as_it_was) {
    for (const char* text :
         {"void f() { if (a) }", "void f() { (] }", "void f() { x = a ? b; }", "void f() { if }",
          "void f() { do x(); }", "void f() { for (a; b) c(); }", "void f() { g()"}) {
        const Instrumented done = instrument(text);
        EXPECT_EQ(done.text, text);
        EXPECT_EQ(done.counters, 0u) << text;
    }
}

TEST(instrument, functions_of_one_name_are_told_apart_and_know_their_lines) {
    const Instrumented done =
        instrument("float f(vec2 a,\n  in float b[2]) { return 1.0; }\nfloat f(int a) {\n}\nint g() {}");
    ASSERT_EQ(done.functions.size(), 3u);
    EXPECT_EQ(done.functions[0].name, "f(vec2 float)");
    EXPECT_EQ(done.functions[1].name, "f(int)");
    EXPECT_EQ(done.functions[2].name, "g");
    EXPECT_EQ(done.functions[1].line, 3);
    EXPECT_EQ(done.functions[1].last, 4);
}

TEST(instrument, counters_begin_where_they_are_told_to) {
    EXPECT_EQ(instrument("void f() { if (a) b(); }", 40).text,
              "void f() { gnomon_hit(40u); if (gnomon_was(42u, a)) b(); }");
}

// Of every kernel: lines stay where they are, counters have one place each, and what is taken out again
// leaves the author's text.
TEST(instrument, changes_no_kernel_s_lines_and_uses_every_counter_once) {
    std::size_t seen = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(testing::kernels_folder())) {
        if (!entry.is_regular_file()) continue;
        const std::string text = read_file(entry.path());
        const Instrumented done = instrument(text, 8);
        EXPECT_EQ(std::ranges::count(done.text, '\n'), std::ranges::count(text, '\n')) << entry.path();
        std::multiset<std::size_t> used;
        for (const std::string call : {"gnomon_hit(", "gnomon_was("})
            for (std::size_t at = done.text.find(call); at != done.text.npos;
                 at = done.text.find(call, at + 1)) {
                const std::size_t counter = std::stoul(done.text.substr(at + call.size()));
                used.insert(counter);
                if (call == "gnomon_was(") used.insert(counter + 1);
            }
        // One may be left over between pairs, which begin with an even number.
        EXPECT_LE(used.size(), done.counters) << entry.path();
        EXPECT_GE(used.size() + 1, done.counters) << entry.path();
        for (const std::size_t counter : used) {
            EXPECT_EQ(used.count(counter), 1u) << entry.path();
            EXPECT_GE(counter, 8u) << entry.path();
            EXPECT_LT(counter, 8 + done.counters) << entry.path();
        }
        for (const Branch& branch : done.branches)
            if (branch.kind == Branch::Kind::condition) {
                EXPECT_EQ(branch.outcomes[0].counter % 2, 0u) << entry.path();
                EXPECT_EQ(branch.outcomes[1].counter, branch.outcomes[0].counter + 1) << entry.path();
            }
        seen += done.branches.size();
    }
    EXPECT_GT(seen, 300u);
}

} // namespace
} // namespace gnomon::coverage
