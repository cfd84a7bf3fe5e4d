// Includes between kernel files, and errors on the author's line.
#include "runtime/error.h"
#include "runtime/glsl/compiler.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::count_of;
using testing::TemporaryFolder;

std::string message_of(const glsl::Sources& sources, const std::string& text) {
    try {
        glsl::compile(sources, text, "author.glsl", glsl::Stage::compute);
    } catch (const CompileError& error) {
        return error.what();
    }
    ADD_FAILURE() << "this compiled: " << text;
    return {};
}

constexpr const char* head = "layout(local_size_x = 1) in;\n";

TEST(glsl, a_file_is_included_once_however_often_it_is_named) {
    const TemporaryFolder folder;
    folder.write("a.glsl", "#include \"b.glsl\"\nfloat a() { return b(); }\n");
    folder.write("b.glsl", "float b() { return 1.0; }\n");
    const std::string text =
        glsl::expand({folder.path(), {}}, "#include \"b.glsl\"\n#include \"a.glsl\"\n", "main");
    EXPECT_EQ(count_of(text, "float b()"), 1u);
    EXPECT_EQ(count_of(text, "float a()"), 1u);
    EXPECT_LT(text.find("float b()"), text.find("float a()"));
}

TEST(glsl, files_may_include_each_other) {
    const TemporaryFolder folder;
    folder.write("a.glsl", "#include \"b.glsl\"\nint a;\n");
    folder.write("b.glsl", "#include \"a.glsl\"\nint b;\n");
    const std::string text = glsl::expand({folder.path(), {}}, "#include \"a.glsl\"\n", "main");
    EXPECT_EQ(count_of(text, "int a;"), 1u);
    EXPECT_EQ(count_of(text, "int b;"), 1u);
}

TEST(glsl, generated_texts_are_included_by_angle_brackets) {
    const TemporaryFolder folder;
    const std::string text =
        glsl::expand({folder.path(), {{"x/cases", "int generated;\n"}}}, "#include <x/cases>\n", "m");
    EXPECT_EQ(count_of(text, "int generated;"), 1u);
    EXPECT_THROW(glsl::expand({folder.path(), {}}, "#include <x/cases>\n", "m"), CompileError);
}

TEST(glsl, an_overlaid_text_stands_for_the_file_and_keeps_its_name) {
    const TemporaryFolder folder;
    folder.write("a.glsl", "int a;\n");
    glsl::Sources sources{folder.path(), {}, {{"a.glsl", "int other;\n"}, {"new.glsl", "int added;\n"}}};
    const std::string text = glsl::expand(sources, "#include \"a.glsl\"\n#include \"new.glsl\"\n", "main");
    EXPECT_EQ(count_of(text, "int a;"), 0u);
    EXPECT_EQ(count_of(text, "int other;"), 1u);
    EXPECT_EQ(count_of(text, "int added;"), 1u);
    EXPECT_EQ(count_of(text, "/a.glsl\"\n"), 1u);
}

TEST(glsl, a_missing_include_is_an_error_on_its_line) {
    const TemporaryFolder folder;
    folder.write("a.glsl", "// one\n// two\n#include \"gone.glsl\"\n");
    const std::string message = message_of({folder.path(), {}}, "#include \"a.glsl\"\n");
    EXPECT_NE(message.find("/a.glsl:3: cannot include \"gone.glsl\""), message.npos) << message;
}

TEST(glsl, nothing_but_a_comment_stands_behind_an_include) {
    const TemporaryFolder folder;
    folder.write("a.glsl", "int a;\n");
    const glsl::Sources sources{folder.path(), {}};
    EXPECT_EQ(count_of(glsl::expand(sources, "#include \"a.glsl\" // why\r\nint b;\n", "m"), "int a;"), 1u);
    EXPECT_EQ(count_of(glsl::expand(sources, "#include \"a.glsl\"\t\r\n", "m"), "int a;"), 1u);
    for (const std::string behind : {"int b;", "/* why */", ";", "<a.glsl>"}) { // it would be lost silently
        const std::string message = testing::error_of(
            [&] { glsl::expand(sources, "int c;\n#include \"a.glsl\" " + behind + "\n", "m"); });
        EXPECT_TRUE(message.starts_with("m:2: behind an include only a comment (//)")) << message;
    }
}

TEST(glsl, frozen_sources_see_no_later_edit) {
    const TemporaryFolder folder;
    folder.write("a.glsl", "int before;\n");
    const glsl::Sources live{folder.path(), {}}, frozen = glsl::frozen(live);
    folder.write("a.glsl", "int after;\n");
    EXPECT_EQ(count_of(glsl::expand(live, "#include \"a.glsl\"\n", "m"), "int after;"), 1u);
    EXPECT_EQ(count_of(glsl::expand(frozen, "#include \"a.glsl\"\n", "m"), "int before;"), 1u);
    EXPECT_EQ(glsl::text_of(frozen, "a.glsl"), "int before;\n");
    EXPECT_THROW(glsl::text_of(frozen, "gone.glsl"), Error);
}

TEST(glsl, a_nul_byte_is_an_error_on_its_line) {
    using namespace std::string_literals;
    const std::string message = message_of({testing::kernels_folder(), {}}, "int a;\nint\0 b;\n"s);
    EXPECT_NE(message.find(":2: a NUL byte"), message.npos) << message;
}

TEST(glsl, an_error_is_on_the_author_s_line) {
    const glsl::Sources sources{testing::kernels_folder(), {}};
    EXPECT_TRUE(message_of(sources, std::string(head) + "\nvoid main() { int i = missing; }\n")
                    .starts_with("author.glsl:3: "));
}

TEST(glsl, an_error_in_an_included_file_is_on_its_line_and_those_after_it_on_theirs) {
    const TemporaryFolder folder;
    folder.write("good.glsl", "float good() {\n\n\n    return 1.0;\n}\n");
    folder.write("bad.glsl", "// fine\nfloat bad() { return nothing; }\n");
    const glsl::Sources sources{folder.path(), {}};
    const std::string inside =
        message_of(sources, "#include \"good.glsl\"\n#include \"bad.glsl\"\nvoid main() {}\n");
    EXPECT_NE(inside.find("/bad.glsl:2: "), inside.npos) << inside;
    const std::string after = message_of(sources, "#include \"good.glsl\"\nvoid main() { nothing(); }\n");
    EXPECT_NE(after.find("author.glsl:2: "), after.npos) << after;
}

TEST(glsl, a_shader_that_ends_without_a_newline_compiles) {
    const glsl::Spirv words = glsl::compile({testing::kernels_folder(), {}},
                                            std::string(head) + "void main() {}", "m", glsl::Stage::compute);
    ASSERT_FALSE(words.empty());
    EXPECT_EQ(words[0], 0x07230203u); // SPIR-V's magic number
}

} // namespace
} // namespace gnomon
