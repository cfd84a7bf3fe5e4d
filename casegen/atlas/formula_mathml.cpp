#include "casegen/atlas/mathml.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace gnomon::atlas {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Words that are no names.
constexpr std::array<std::string_view, 4> grammar{"if", "otherwise", "and", "or"};

struct Token {
    enum class Kind { end, number, name, sign };
    Kind kind = Kind::end;
    std::string text;
};

/// A character as a message shows it: all bytes of a UTF-8 one, a number for what cannot be printed.
std::string shown(std::string_view text, std::size_t at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte < 0x20 || byte == 0x7f) return fmt::format("byte {:#04x}", byte);
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) ++end;
    return fmt::format("'{}'", text.substr(at, end - at));
}

std::vector<Token> tokens_of(std::string_view text) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < text.size();) {
        const auto take_while = [&](auto&& belongs) {
            std::size_t end = at;
            while (end < text.size() && belongs(text[end])) ++end;
            return std::string(text.substr(at, end - at));
        };
        Token token;
        if (text[at] == ' ') {
            ++at;
            continue;
        }
        if (is_digit(text[at])) {
            token = {Token::Kind::number, take_while([](char c) { return is_digit(c) || c == '.'; })};
        } else if (is_letter(text[at])) { // p.x is one name, and so is n_-y
            char before = 0;
            token = {Token::Kind::name, take_while([&](char c) {
                         const bool sign = (c == '-' || c == '+') && before == '_';
                         before = c;
                         return is_letter(c) || is_digit(c) || c == '.' || sign;
                     })};
        } else {
            const std::string_view two = text.substr(at, 2);
            if (two == "<=" || two == ">=" || two == "!=")
                token = {Token::Kind::sign, std::string(two)};
            else if (std::string_view("+-*/^()|,;<>=").find(text[at]) != std::string_view::npos)
                token = {Token::Kind::sign, std::string(1, text[at])};
            else
                throw Error("formula \"{}\": unknown character {} at column {}", text, shown(text, at),
                            at + 1);
        }
        at += token.text.size();
        tokens.push_back(std::move(token));
    }
    tokens.emplace_back();
    return tokens;
}

std::string indexed(const std::string& base, const std::string& index) {
    return fmt::format("<msub><mi>{}</mi><mrow>{}</mrow></msub>", base, index);
}

/// What has been read, and what it is without the parentheses around it: a fraction's bar replaces them.
struct Part {
    std::string mathml, bare;
    explicit Part(std::string text) : mathml(text), bare(std::move(text)) {}
    Part(std::string text, std::string without) : mathml(std::move(text)), bare(std::move(without)) {}
};

class Parser {
public:
    explicit Parser(std::string_view text) : text_(text), tokens_(tokens_of(text)) {}

    std::string formula() {
        std::vector<std::string> rows;
        bool conditional = false;
        do {
            const std::string value = expression().mathml;
            std::string condition;
            if (take("if"))
                condition = "<mtext>if&#160;</mtext>" + this->condition();
            else if (take("otherwise"))
                condition = "<mtext>otherwise</mtext>";
            conditional = conditional || !condition.empty();
            rows.push_back(fmt::format("<mtr><mtd><mrow>{}</mrow></mtd><mtd><mrow>{}</mrow></mtd></mtr>",
                                       value, condition));
            if (rows.size() == 1 && !conditional && now().kind == Token::Kind::end) return value;
        } while (take(";"));
        if (now().kind != Token::Kind::end) unexpected();
        return fmt::format("<mo form=\"prefix\" stretchy=\"true\">{{</mo><mtable>{}</mtable>",
                           fmt::join(rows, ""));
    }

private:
    const Token& now() const { return tokens_[at_]; }
    bool is(std::string_view text) const { return now().kind != Token::Kind::end && now().text == text; }
    bool take(std::string_view text) {
        if (!is(text)) return false;
        ++at_;
        return true;
    }
    void require(std::string_view text) {
        if (!take(text)) unexpected();
    }
    [[noreturn]] void unexpected() const {
        if (now().kind == Token::Kind::end)
            throw Error("formula \"{}\": ends where something must follow", text_);
        throw Error("formula \"{}\": \"{}\" does not belong where it stands (word {})", text_, now().text,
                    at_ + 1);
    }

    std::string condition() {
        std::string text = comparison();
        for (;;) {
            if (take("and"))
                text += "<mo>∧</mo>" + comparison();
            else if (take("or"))
                text += "<mo>∨</mo>" + comparison();
            else
                return text;
        }
    }

    std::string comparison() {
        static const std::map<std::string, std::string> signs{{"<", "&lt;"}, {"<=", "≤"}, {">", "&gt;"},
                                                              {">=", "≥"},   {"=", "="},  {"!=", "≠"}};
        const std::size_t begin = at_;
        const std::string left = expression().mathml;
        const auto sign = signs.find(now().text);
        const bool only_a_name = at_ == begin + 1 && tokens_[begin].kind == Token::Kind::name;
        if (sign == signs.end() && only_a_name) return left;
        if (sign == signs.end()) unexpected();
        ++at_;
        return fmt::format("{}<mo>{}</mo>{}", left, sign->second, expression().mathml);
    }

    Part expression() {
        Part left = term();
        while (is("+") || is("-")) {
            const char* sign = take("+") ? "+" : (++at_, "−");
            left = Part(fmt::format("{}<mo>{}</mo>{}", left.mathml, sign, term().mathml));
        }
        return left;
    }

    Part term() {
        Part left = factor();
        while (is("*") || is("/")) {
            if (take("*")) {
                left = Part(fmt::format("{}<mo>·</mo>{}", left.mathml, factor().mathml));
                continue;
            }
            require("/");
            left =
                Part(fmt::format("<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>", left.bare, factor().bare));
        }
        return left;
    }

    Part factor() {
        if (take("-")) return Part("<mo form=\"prefix\">−</mo>" + factor().mathml);
        Part base = primary();
        if (!take("^")) return base;
        return Part(fmt::format("<msup><mrow>{}</mrow><mrow>{}</mrow></msup>", base.mathml, factor().bare));
    }

    Part primary() {
        if (take("(")) {
            const std::string inner = expression().mathml;
            require(")");
            return {fmt::format("<mrow><mo>(</mo>{}<mo>)</mo></mrow>", inner), inner};
        }
        if (take("|")) {
            const std::string inner = expression().mathml;
            require("|");
            return Part(
                fmt::format("<mrow><mo form=\"prefix\">|</mo>{}<mo form=\"postfix\">|</mo></mrow>", inner));
        }
        if (now().kind == Token::Kind::number) return Part("<mn>" + tokens_[at_++].text + "</mn>");
        if (now().kind != Token::Kind::name || std::ranges::count(grammar, now().text) > 0) unexpected();
        const std::string name = tokens_[at_++].text;
        if (!take("(")) return Part(name_to_mathml(name));
        std::string arguments = expression().mathml;
        while (take(",")) arguments += "<mo separator=\"true\">,</mo>" + expression().mathml;
        require(")");
        return Part(fmt::format("<mrow>{}<mo>&#x2061;</mo><mrow><mo>(</mo>{}<mo>)</mo></mrow></mrow>",
                                name_to_mathml(name), arguments));
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
};

} // namespace

std::string name_to_mathml(std::string_view name) {
    static const std::map<std::string, std::pair<std::string, std::string>, std::less<>> documents{
        {"along_x", {"d", "<mi>on.r</mi>"}},
        {"along_y", {"d", "<mi>on.g</mi>"}},
        {"side_x", {"d", "<mi>c.r</mi>"}},
        {"side_y", {"d", "<mi>c.g</mi>"}},
    };
    if (const auto known = documents.find(name); known != documents.end())
        return indexed(known->second.first, known->second.second);
    if (name.size() > 1 && std::ranges::all_of(name, [](char c) { return c >= 'A' && c <= 'Z'; }))
        return fmt::format("<mtext>{}</mtext>", name);
    const std::size_t cut = name.find_first_of("_.");
    if (cut == std::string_view::npos || cut == 0 || cut + 1 == name.size())
        return fmt::format("<mi>{}</mi>", name);
    const std::string base(name.substr(0, cut));
    std::string index(name.substr(cut + 1)), sign;
    if (index.size() > 1 && (index.front() == '-' || index.front() == '+')) {
        sign = fmt::format("<mo form=\"prefix\">{}</mo>", index.front() == '-' ? "−" : "+");
        index.erase(0, 1);
    }
    const char* element = std::ranges::all_of(index, is_digit) ? "mn" : "mi";
    return indexed(base, fmt::format("{0}<{1}>{2}</{1}>", sign, element, index));
}

std::set<std::string> names_in(std::string_view formula) {
    const std::vector<Token> tokens = tokens_of(formula);
    std::set<std::string> names;
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (tokens[i].kind == Token::Kind::name && std::ranges::count(grammar, tokens[i].text) == 0 &&
            tokens[i + 1].text != "(") // the last token is the end
            names.insert(tokens[i].text);
    return names;
}

std::string formula_to_mathml(std::string_view formula) {
    return fmt::format("<math displaystyle=\"true\"><mrow>{}</mrow></math>", Parser(formula).formula());
}

} // namespace gnomon::atlas
