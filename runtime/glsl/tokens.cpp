#include "runtime/glsl/tokens.h"

#include <algorithm>
#include <array>

namespace gnomon::glsl {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::array<std::string_view, 22> symbols{
    "<<=", ">>=", "++", "--", "<=", ">=", "==", "!=", "&&", "||", "^^",
    "+=",  "-=",  "*=", "/=", "%=", "&=", "|=", "^=", "<<", ">>", "##"};

/// Goes through the text character by character.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::vector<Token> run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '\n') {
                first_of_line_ = true;
                step(1);
            } else if (c == ' ' || c == '\t' || c == '\r') {
                step(1);
            } else if (looking_at("//")) {
                skip_line();
            } else if (looking_at("/*")) {
                step(std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2 - at_);
            } else if (c == '#' && first_of_line_) {
                skip_line();
            } else {
                take(is_letter(c) ? identifier() : is_number(at_) ? number() : symbol(), kind(c));
            }
        }
        return std::move(tokens_);
    }

private:
    bool looking_at(std::string_view what) const { return text_.substr(at_).starts_with(what); }
    bool is_number(std::size_t at) const {
        return is_digit(text_[at]) || (text_[at] == '.' && at + 1 < text_.size() && is_digit(text_[at + 1]));
    }
    Token::Kind kind(char c) const {
        return is_letter(c)     ? Token::Kind::identifier
               : is_number(at_) ? Token::Kind::number
                                : Token::Kind::symbol;
    }

    std::size_t identifier() const {
        std::size_t end = at_;
        while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
        return end - at_;
    }
    /// As the preprocessor sees it: digits, letters, points, and signs behind an exponent's letter.
    std::size_t number() const {
        const bool hexadecimal = text_.substr(at_).starts_with("0x") || text_.substr(at_).starts_with("0X");
        std::size_t end = at_ + 1;
        while (end < text_.size()) {
            const char c = text_[end], before = text_[end - 1];
            const bool sign = (c == '+' || c == '-') && (before == 'e' || before == 'E') && !hexadecimal;
            if (!is_letter(c) && !is_digit(c) && c != '.' && !sign) break;
            ++end;
        }
        return end - at_;
    }
    std::size_t symbol() const {
        const auto found =
            std::ranges::find_if(symbols, [&](std::string_view symbol) { return looking_at(symbol); });
        return found != symbols.end() ? found->size() : 1;
    }

    void take(std::size_t size, Token::Kind kind) {
        tokens_.push_back({kind, text_.substr(at_, size), at_, line_});
        first_of_line_ = false;
        step(size);
    }
    void step(std::size_t size) {
        line_ += static_cast<int>(std::ranges::count(text_.substr(at_, size), '\n'));
        at_ += size;
    }
    /// To the end of the line, and on where a backslash stands before it.
    void skip_line() {
        do {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            const bool goes_on = end > at_ && end < text_.size() && text_[end - 1] == '\\';
            step(end - at_ + (goes_on ? 1 : 0));
            if (!goes_on) return;
        } while (at_ < text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool first_of_line_ = true;
    std::vector<Token> tokens_;
};

} // namespace

std::vector<Token> tokens(std::string_view text) { return Scanner(text).run(); }

std::size_t closing(const std::vector<Token>& tokens, std::size_t open) {
    const std::string_view opens = tokens[open].text;
    const std::string_view closes = opens == "(" ? ")" : opens == "[" ? "]" : "}";
    std::size_t depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        if (tokens[i].is(opens)) ++depth;
        if (tokens[i].is(closes) && --depth == 0) return i;
    }
    return tokens.size();
}

std::vector<Function> functions(const std::vector<Token>& tokens) {
    using enum Token::Kind;
    std::vector<Function> found;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (tokens[i].is("{")) { // a struct, a block: no function begins in it
            i = closing(tokens, i);
            continue;
        }
        if (tokens[i].kind != identifier || tokens[i + 1].kind != identifier || !tokens[i + 2].is("("))
            continue;
        const std::size_t close = closing(tokens, i + 2);
        if (close + 1 >= tokens.size() || !tokens[close + 1].is("{")) continue;
        const std::size_t end = closing(tokens, close + 1);
        if (end == tokens.size()) break; // the text ends before the body
        found.push_back({tokens[i + 1].text, i, i + 2, close + 1, end});
        i = end;
    }
    return found;
}

} // namespace gnomon::glsl
