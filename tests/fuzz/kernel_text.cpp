// Kernels' files before a compiler sees them: includes, tokens, functions.
#include "casegen/kernel_case.h"
#include "runtime/glsl/compiler.h"
#include "runtime/glsl/tokens.h"
#include "tests/fuzz/target.h"

#include <algorithm>

FUZZ_TARGET(kernel_text) {
    using namespace gnomon;
    const std::string text(fuzzing::text_of(data, size));
    glsl::Sources sources;
    sources.root = "/nonexistent/kernels";
    sources.generated = {{"a", text}, {"b", "#include \"x.glsl\"\n#include <a>\n"}};
    sources.overlaid = {{"x.glsl", text}, {"y.glsl", "#include <b>\n"}};
    std::string expanded;
    if (fuzzing::is_read([&] { expanded = glsl::expand(sources, text, "text"); }))
        REQUIRE(std::ranges::count(expanded, '\n') >= std::ranges::count(text, '\n'));
    const std::vector<glsl::Token> tokens = glsl::tokens(text);
    std::size_t end = 0;
    for (const glsl::Token& token : tokens) {
        REQUIRE(token.begin >= end && !token.text.empty());
        end = token.end();
    }
    REQUIRE(end <= text.size());
    for (std::size_t i = 0; i < tokens.size() && i < 50; ++i)
        REQUIRE(glsl::closing(tokens, i) <= tokens.size());
    for (const glsl::Function& function : glsl::functions(tokens))
        REQUIRE(function.type < function.open && function.open < function.begin &&
                function.begin < function.end && function.end < tokens.size());
    leading_comment(text);
    return 0;
}
