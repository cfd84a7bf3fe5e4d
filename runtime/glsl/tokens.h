// GLSL text as a list of tokens, for those who change a kernel's text or count what of it was reached. Not a
// parser: comments and preprocessor lines are left out, and nothing is known of types.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace gnomon::glsl {

struct Token {
    enum class Kind { identifier, number, symbol };
    Kind kind = Kind::symbol;
    std::string_view text; ///< a part of the text that was scanned: "case_09", "1.0e-3", "<=", "{"
    std::size_t begin = 0; ///< its first character in that text
    int line = 1;          ///< counted from 1

    std::size_t end() const { return begin + text.size(); }
    bool is(std::string_view what) const { return text == what; }
};

/// The tokens of a file's text, in order; keywords are identifiers. The longest symbol wins: "<<=" is one. A
/// preprocessor line ends where its last continued line does. Characters that GLSL does not know are symbols
/// of their own. The text must outlive the tokens.
std::vector<Token> tokens(std::string_view text);

/// The number of the token that closes what token `open` opens, "(", "[" or "{"; tokens.size() if none does.
std::size_t closing(const std::vector<Token>& tokens, std::size_t open);

/// A function with a body.
struct Function {
    std::string_view name;
    std::size_t type = 0;  ///< the token of its result's type; qualifiers before it are not part of it
    std::size_t open = 0;  ///< "(" of the parameters
    std::size_t begin = 0; ///< "{"
    std::size_t end = 0;   ///< "}"
};

/// All of them in the order of the text; prototypes are none, nor is what the text breaks off in.
std::vector<Function> functions(const std::vector<Token>& tokens);

} // namespace gnomon::glsl
