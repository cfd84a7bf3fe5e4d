// How GLSL text falls into tokens and functions: whoever changes kernels or counts lines relies on it.
#include "runtime/files.h"
#include "runtime/glsl/tokens.h"
#include "tests/support/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace gnomon::glsl {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> texts(std::string_view text) {
    std::vector<std::string> found;
    for (const Token& token : tokens(text)) found.emplace_back(token.text);
    return found;
}

TEST(tokens, the_longest_symbol_wins) {
    EXPECT_THAT(texts("a<<=b<=c<d&&e^^f++"),
                ElementsAre("a", "<<=", "b", "<=", "c", "<", "d", "&&", "e", "^^", "f", "++"));
}

TEST(tokens, numbers_keep_their_points_exponents_and_suffixes) {
    EXPECT_THAT(texts("1.0e-37+.5-2u*0x1e+3"),
                ElementsAre("1.0e-37", "+", ".5", "-", "2u", "*", "0x1e", "+", "3"));
    EXPECT_EQ(tokens(".5").front().kind, Token::Kind::number);
    EXPECT_THAT(texts("p.x"), ElementsAre("p", ".", "x"));
}

TEST(tokens, comments_and_preprocessor_lines_are_none_and_lines_are_counted_through_them) {
    const std::vector<Token> all = tokens("// a\n#define B \\\n  c\n/* d\n e */ f\n g # h");
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].text, "f");
    EXPECT_EQ(all[0].line, 5);
    EXPECT_EQ(all[1].text, "g");
    EXPECT_EQ(all[1].line, 6);
    EXPECT_EQ(all[2].text, "#") << "not the first of its line";
    EXPECT_TRUE(tokens("/* never closed").empty());
    EXPECT_TRUE(tokens("/*").empty());
    EXPECT_TRUE(tokens("").empty());
}

TEST(functions, whose_body_the_text_breaks_off_in_are_none) {
    for (const char* text : {"int f() {", "int f() { { }", "int f() { return (1; "})
        EXPECT_TRUE(functions(tokens(text)).empty()) << text;
    EXPECT_EQ(functions(tokens("int f() {} int g() {")).size(), 1u);
}

TEST(functions, prototypes_structs_and_blocks_are_none) {
    const std::string text = "struct S { vec2 a; };\nfloat f(vec2 p);\nconst float k = g(2.0);\n"
                             "float f(vec2 p) { if (p.x < 0.0) { return 0.0; } return p.x; }\n"
                             "layout(std430) buffer B { uint b[]; };\nvoid g() {}";
    const std::vector<Token> all = tokens(text);
    const std::vector<Function> found = functions(all);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].name, "f");
    EXPECT_EQ(all[found[0].type].text, "float");
    EXPECT_EQ(all[found[0].begin].text, "{");
    EXPECT_EQ(all[found[0].end].line, 4);
    EXPECT_EQ(found[1].name, "g");
    EXPECT_EQ(found[1].end, all.size() - 1);
}

TEST(functions, every_kernel_defines_the_function_that_its_path_says) {
    std::size_t kernels = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(testing::kernels_folder())) {
        if (entry.path().extension() != ".glsl") continue;
        std::string name = entry.path().lexically_relative(testing::kernels_folder()).generic_string();
        name.resize(name.size() - 5);
        for (char& c : name)
            if (c == '/') c = '_';
        const std::string text = read_file(entry.path());
        const std::vector<Token> all = tokens(text);
        std::size_t defined = 0;
        for (const Function& function : functions(all)) defined += function.name == name ? 1 : 0;
        EXPECT_EQ(defined, 1u) << name;
        ++kernels;
    }
    EXPECT_GT(kernels, 150u);
}

} // namespace
} // namespace gnomon::glsl
