#include "casegen/coverage/instrument.h"

#include "runtime/glsl/tokens.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace gnomon::coverage {
namespace {

using glsl::Token;

/// The text is no GLSL.
struct Malformed {};

bool is_any_of(const Token& token, std::initializer_list<std::string_view> texts) {
    return std::ranges::find(texts, token.text) != texts.end();
}
bool is_qualifier(const Token& token) {
    return is_any_of(token, {"const", "precise", "highp", "mediump", "lowp", "in", "out", "inout"});
}
bool is_assignment(const Token& token) {
    return is_any_of(token, {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="});
}
bool is_opening(const Token& token) { return is_any_of(token, {"(", "[", "{"}); }
bool chooses(const Token& token) { return is_any_of(token, {"?", "&&", "||"}); }
/// What follows it in its block is not reached as often as what stands before it.
bool leaves(const Token& token) { return is_any_of(token, {"return", "break", "continue", "discard"}); }

bool brackets_close(const std::vector<Token>& tokens) {
    std::vector<std::string_view> open;
    for (const Token& token : tokens) {
        if (is_opening(token)) open.push_back(token.text);
        if (!is_any_of(token, {")", "]", "}"})) continue;
        const std::string_view opening = token.is(")") ? "(" : token.is("]") ? "[" : "{";
        if (open.empty() || open.back() != opening) return false;
        open.pop_back();
    }
    return open.empty();
}

/// A preprocessor line, with those that continue it.
struct Directive {
    int line = 1;
    std::string name, body;
};

std::vector<Directive> directives(std::string_view text) {
    std::vector<Directive> found;
    bool continued = false;
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view rest = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto skip_blanks = [&] {
            rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        };
        const bool goes_on = rest.ends_with('\\');
        if (continued) {
            found.back().body += rest;
        } else {
            skip_blanks();
            if (!rest.starts_with('#')) continue;
            rest.remove_prefix(1);
            skip_blanks();
            const std::size_t name = std::min(rest.find_first_of(" \t(\"<"), rest.size());
            found.push_back({line, std::string(rest.substr(0, name)), std::string(rest.substr(name))});
        }
        continued = goes_on;
    }
    return found;
}

class Rewriter {
public:
    Rewriter(std::string_view text, std::size_t first)
        : text_(text), tokens_(glsl::tokens(text)), first_(first) {}

    Instrumented run() {
        if (!brackets_close(tokens_)) throw Malformed();
        const std::vector<glsl::Function> all = glsl::functions(tokens_);
        std::size_t outside = 0;
        for (const glsl::Function& function : all) {
            omit_constants(outside, function.type);
            const std::size_t counter = take_one();
            result_.functions.push_back(
                {name(all, function), tokens_[function.type].line, tokens_[function.end].line, counter});
            note_lines(function.type, function.begin + 1, counter);
            insert(tokens_[function.begin].end(), hit(counter));
            block(function.begin, counter);
            outside = function.end + 1;
        }
        omit_constants(outside, tokens_.size());
        copy_to(text_.size());
        return std::move(result_);
    }

private:
    // The text so far, and counters.

    void copy_to(std::size_t position) {
        result_.text += text_.substr(copied_, position - copied_);
        copied_ = position;
    }
    void insert(std::size_t position, const std::string& what) {
        copy_to(position);
        result_.text += what;
    }
    std::size_t take_one() {
        if (spare_) return *std::exchange(spare_, std::nullopt);
        return first_ + result_.counters++;
    }
    /// Two, the first of them even: bits of one word.
    std::size_t take_pair() {
        if (result_.counters % 2 != 0) spare_ = first_ + result_.counters++;
        result_.counters += 2;
        return first_ + result_.counters - 2;
    }
    static std::string hit(std::size_t counter) { return fmt::format(" gnomon_hit({}u);", counter); }

    // What tokens say.

    const Token& at(std::size_t i) const {
        if (i >= tokens_.size()) throw Malformed();
        return tokens_[i];
    }
    void require(std::size_t i, std::string_view text) const {
        if (!at(i).is(text)) throw Malformed();
    }
    std::size_t closing(std::size_t open) const { return glsl::closing(tokens_, open); }
    /// The first token of [begin, end), outside brackets, for which `is` holds; `end` if none.
    template <typename Is>
    std::size_t find_where(std::size_t begin, std::size_t end, const Is& is) const {
        for (std::size_t i = begin; i < end; ++i) {
            if (is(tokens_[i])) return i;
            if (is_opening(tokens_[i])) i = closing(i);
        }
        return end;
    }
    std::size_t find(std::size_t begin, std::size_t end, std::string_view text) const {
        return find_where(begin, end, [&](const Token& token) { return token.is(text); });
    }
    /// "(" … ")" and nothing else.
    bool is_group(std::size_t begin, std::size_t end) const {
        return end > begin + 1 && tokens_[begin].is("(") && closing(begin) == end - 1;
    }
    /// As the author wrote it, on one line and without comments.
    std::string words(std::size_t begin, std::size_t end) const {
        std::string joined;
        for (std::size_t i = begin; i < end; ++i) {
            if (i > begin && tokens_[i].begin > tokens_[i - 1].end()) joined += ' ';
            joined += tokens_[i].text;
        }
        return joined;
    }
    std::size_t skip_qualifiers(std::size_t begin, std::size_t end) const {
        while (begin < end && is_qualifier(tokens_[begin])) ++begin;
        return begin;
    }
    /// A type and a name: the number of the name's token; `end` if this is no declaration.
    std::size_t declared_name(std::size_t begin, std::size_t end) const {
        std::size_t i = skip_qualifiers(begin, end);
        if (i >= end || tokens_[i].kind != Token::Kind::identifier) return end;
        ++i;
        while (i < end && tokens_[i].is("[")) i = closing(i) + 1;
        return i < end && tokens_[i].kind == Token::Kind::identifier ? i : end;
    }

    /// "bounded", or "bounded(vec2)" where the text has several of that name.
    std::string name(const std::vector<glsl::Function>& all, const glsl::Function& function) const {
        std::string name(function.name);
        if (std::ranges::count(all, function.name, &glsl::Function::name) == 1) return name;
        std::string types;
        const std::size_t close = closing(function.open);
        for (std::size_t i = function.open + 1; i < close;) {
            const std::size_t comma = find(i, close, ",");
            const std::size_t type = skip_qualifiers(i, comma);
            if (type < comma) types += fmt::format("{}{}", types.empty() ? "" : " ", tokens_[type].text);
            i = comma + 1;
        }
        return fmt::format("{}({})", name, types);
    }

    void note_lines(std::size_t begin, std::size_t end, std::size_t counter) {
        result_.lines.push_back({tokens_[begin].line, tokens_[end - 1].line, counter});
    }
    void omit_constants(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (chooses(tokens_[i])) {
                result_.omissions.push_back({tokens_[i].line, "must be constant"});
                return;
            }
    }

    // Expressions.

    void expression(std::size_t begin, std::size_t end) {
        while (begin < end) {
            const std::size_t comma = find(begin, end, ",");
            assignment(begin, comma);
            begin = comma + 1;
        }
    }

    void assignment(std::size_t begin, std::size_t end) {
        const std::size_t found =
            find_where(begin, end, [](const Token& token) { return token.is("?") || is_assignment(token); });
        if (found == end) return disjunction(begin, end);
        if (tokens_[found].is("?")) return choice(begin, found, end);
        groups(begin, found);
        assignment(found + 1, end);
    }

    void choice(std::size_t begin, std::size_t question, std::size_t end) {
        std::size_t depth = 0;
        const std::size_t colon = find_where(question + 1, end, [&](const Token& token) {
            if (token.is("?")) ++depth;
            return token.is(":") && depth-- == 0;
        });
        if (colon == end) throw Malformed();
        condition(begin, question);
        expression(question + 1, colon);
        assignment(colon + 1, end);
    }

    void disjunction(std::size_t begin, std::size_t end) {
        operands(begin, end, "||", [&](std::size_t b, std::size_t e, bool several) {
            if (several)
                condition(b, e);
            else
                exclusive(b, e);
        });
    }
    void exclusive(std::size_t begin, std::size_t end) {
        operands(begin, end, "^^", [&](std::size_t b, std::size_t e, bool) { conjunction(b, e); });
    }
    void conjunction(std::size_t begin, std::size_t end) {
        operands(begin, end, "&&", [&](std::size_t b, std::size_t e, bool several) {
            if (several)
                condition(b, e);
            else
                groups(b, e);
        });
    }
    template <typename Each>
    void operands(std::size_t begin, std::size_t end, std::string_view symbol, const Each& each) {
        const bool several = find(begin, end, symbol) != end;
        while (begin < end) {
            const std::size_t next = find(begin, end, symbol);
            each(begin, next, several);
            begin = next + 1;
        }
    }

    /// What stands in brackets; the size in an array's constructor, float[3](…), must be constant.
    void groups(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!is_opening(tokens_[i])) continue;
            const std::size_t close = closing(i);
            if (!(tokens_[i].is("[") && close + 1 < end && tokens_[close + 1].is("(")))
                expression(i + 1, close);
            i = close;
        }
    }

    /// a && b, also in brackets or negated: its operands say how it came out.
    bool is_compound(std::size_t begin, std::size_t end) const {
        if (is_group(begin, end)) return is_compound(begin + 1, end - 1);
        if (end > begin + 1 && tokens_[begin].is("!") && is_group(begin + 1, end))
            return is_compound(begin + 1, end);
        const auto other = [](const Token& token) {
            return is_any_of(token, {"?", ",", "^^"}) || is_assignment(token);
        };
        return find_where(begin, end, other) == end && find_where(begin, end, [](const Token& token) {
                                                           return is_any_of(token, {"&&", "||"});
                                                       }) != end;
    }

    /// Counts how often it is true and false. The counter of "true", that of "false" is next; none if it is
    /// compound, or written out as true or false.
    std::optional<std::size_t> condition(std::size_t begin, std::size_t end) {
        if (begin >= end) return {};
        if (is_compound(begin, end)) {
            expression(begin, end);
            return {};
        }
        if (end == begin + 1 && is_any_of(tokens_[begin], {"true", "false"})) return {};
        const std::size_t counter = take_pair();
        const int line = tokens_[begin].line;
        result_.branches.push_back({Branch::Kind::condition,
                                    line,
                                    words(begin, end),
                                    {{"true", line, counter}, {"false", line, counter + 1}}});
        const bool list = find(begin, end, ",") != end;
        insert(tokens_[begin].begin, fmt::format("gnomon_was({}u, {}", counter, list ? "(" : ""));
        expression(begin, end);
        insert(tokens_[end - 1].end(), list ? "))" : ")");
        return counter;
    }

    /// An expression or a declaration, as a statement or where a for begins.
    void simple(std::size_t begin, std::size_t end) {
        const std::size_t name = declared_name(begin, end);
        if (name == end) return expression(begin, end);
        const bool constant = std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                                          tokens_.begin() + static_cast<std::ptrdiff_t>(name),
                                          [](const Token& token) { return token.is("const"); });
        if (constant || tokens_[begin].is("struct")) return omit_constants(begin, end);
        for (std::size_t i = name; i < end;) { // a, b[3], c = …
            const std::size_t comma = find(i, end, ",");
            const std::size_t equals = find(i, comma, "=");
            omit_constants(i, equals);
            if (equals < comma) assignment(equals + 1, comma);
            i = comma + 1;
        }
    }

    // Statements. `reached` is the counter of what comes next in a block: none before somebody needs it.

    using Reached = std::optional<std::size_t>;

    std::size_t count_here(Reached& reached, std::size_t token) {
        if (!reached) {
            reached = take_one();
            insert(tokens_[token].begin, fmt::format("gnomon_hit({}u); ", *reached));
        }
        return *reached;
    }

    /// All between braces; returns the token behind them.
    std::size_t block(std::size_t open, Reached reached) {
        const std::size_t close = closing(open);
        for (std::size_t i = open + 1; i < close;) i = statement(i, reached);
        return close + 1;
    }

    /// What an if, an else or a loop governs. `reached`: the counter that says how often, if there is one.
    std::size_t body(std::size_t begin, Reached reached) {
        if (at(begin).is("{")) return block(begin, reached);
        if (reached || at(begin).is(";")) return statement(begin, reached);
        insert(tokens_[begin].begin, "{ ");
        const std::size_t end = statement(begin, reached);
        insert(tokens_[end - 1].end(), " }");
        return end;
    }

    /// Returns the token behind the statement. What follows one that can leave is counted anew.
    std::size_t statement(std::size_t begin, Reached& reached) {
        const std::size_t end = statement_of(begin, reached);
        for (std::size_t i = begin; i < end && reached; ++i)
            if (leaves(tokens_[i])) reached.reset();
        return end;
    }

    std::size_t statement_of(std::size_t i, Reached& reached) {
        const Token& first = at(i);
        if (first.is(";")) return i + 1;
        if (first.is("{")) return block(i, count_here(reached, i));
        if (first.is("if")) return if_statement(i, reached);
        if (first.is("for")) return for_statement(i, reached);
        if (first.is("while")) return while_statement(i, reached);
        if (first.is("do")) return do_statement(i, reached);
        if (first.is("switch")) return switch_statement(i, reached);
        const std::size_t end = find(i, tokens_.size(), ";");
        if (end == tokens_.size()) throw Malformed();
        note_lines(i, end + 1, count_here(reached, i));
        if (first.is("return"))
            expression(i + 1, end);
        else
            simple(i, end);
        return end + 1;
    }

    /// The token behind "if (…)", whose condition is counted.
    std::size_t header(std::size_t i, Reached& reached) {
        require(i + 1, "(");
        const std::size_t close = closing(i + 1);
        note_lines(i, close + 1, count_here(reached, i));
        return close;
    }

    std::size_t if_statement(std::size_t i, Reached& reached) {
        const std::size_t close = header(i, reached);
        const Reached holds = condition(i + 2, close);
        const std::size_t end = body(close + 1, holds);
        if (end >= tokens_.size() || !tokens_[end].is("else")) return end;
        return body(end + 1, holds ? Reached(*holds + 1) : Reached());
    }

    std::size_t for_statement(std::size_t i, Reached& reached) {
        const std::size_t close = header(i, reached);
        const std::size_t first = find(i + 2, close, ";");
        const std::size_t second = find(std::min(first + 1, close), close, ";");
        if (second == close) throw Malformed();
        simple(i + 2, first);
        const Reached turns = condition(first + 1, second);
        expression(second + 1, close);
        return body(close + 1, turns);
    }

    std::size_t while_statement(std::size_t i, Reached& reached) {
        const std::size_t close = header(i, reached);
        const bool declares = declared_name(i + 2, close) != close;
        if (declares) simple(i + 2, close);
        return body(close + 1, declares ? Reached() : condition(i + 2, close));
    }

    std::size_t do_statement(std::size_t i, Reached& reached) {
        note_lines(i, i + 1, count_here(reached, i));
        const std::size_t end = body(i + 1, {});
        require(end, "while");
        require(end + 1, "(");
        const std::size_t close = closing(end + 1);
        condition(end + 2, close);
        require(close + 1, ";");
        return close + 2;
    }

    std::size_t switch_statement(std::size_t i, Reached& reached) {
        const std::size_t condition_end = header(i, reached);
        expression(i + 2, condition_end);
        require(condition_end + 1, "{");
        const std::size_t close = closing(condition_end + 1);
        const std::size_t number = result_.branches.size(); // branches within come behind it
        result_.branches.push_back({Branch::Kind::labels, tokens_[i].line, words(i + 2, condition_end), {}});
        bool has_default = false;
        Reached inside;
        const auto outcome = [&](std::string what, int line) {
            inside = take_one();
            result_.branches[number].outcomes.push_back({std::move(what), line, *inside});
        };
        for (std::size_t k = condition_end + 2; k < close;) {
            if (!is_any_of(tokens_[k], {"case", "default"})) {
                k = statement(k, inside);
                continue;
            }
            std::size_t questions = 0;
            const std::size_t colon = find_where(k, close, [&](const Token& token) {
                if (token.is("?")) ++questions;
                return token.is(":") && questions-- == 0;
            });
            if (colon == close) throw Malformed();
            has_default = has_default || tokens_[k].is("default");
            outcome(words(k, colon), tokens_[k].line);
            note_lines(k, colon + 1, *inside);
            insert(tokens_[colon].end(), hit(*inside));
            k = colon + 1;
        }
        if (!has_default) {
            outcome("none of them", tokens_[i].line);
            insert(tokens_[close].begin, fmt::format("break; default:{} ", hit(*inside)));
        }
        return close + 1;
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::size_t first_ = 0, copied_ = 0;
    std::optional<std::size_t> spare_; ///< a counter between pairs that nothing uses yet
    Instrumented result_;
};

} // namespace

Instrumented instrument(std::string_view text, std::size_t first) {
    Instrumented unchanged;
    unchanged.text = text;
    std::vector<Omission> macros;
    for (const Directive& directive : directives(text)) {
        if (directive.name.starts_with("if")) {
            unchanged.omissions = {{directive.line, "the whole text: it has an #if in it"}};
            return unchanged;
        }
        if (directive.name == "define" && std::ranges::any_of(glsl::tokens(directive.body), chooses))
            macros.push_back({directive.line, "is a macro"});
    }
    try {
        Instrumented result = Rewriter(text, first).run();
        result.omissions.insert(result.omissions.end(), macros.begin(), macros.end());
        std::ranges::stable_sort(result.omissions, {}, &Omission::line);
        return result;
    } catch (const Malformed&) {
        return unchanged;
    }
}

Addition counters_around(std::size_t counters, Range active) {
    const std::size_t words = words_of(counters);
    const std::string is_active = fmt::format("counter >= {}u && counter < {}u", active.begin, active.end);
    Addition addition;
    addition.declarations = fmt::format(
        R"(layout(std430, binding = {}) writeonly buffer GnomonReached {{ uint gnomon_reached[]; }};
uint gnomon_bits[{}] = uint[]({});
void gnomon_hit(uint counter) {{
    if ({}) gnomon_bits[counter >> 5] |= 1u << (counter & 31u);
}}
bool gnomon_was(uint counter, bool holds) {{
    if ({}) gnomon_bits[counter >> 5] |= (holds ? 1u : 2u) << (counter & 31u);
    return holds;
}}
)",
        added_binding, words, fmt::join(std::vector<std::string>(words, "0u"), ", "), is_active, is_active);
    for (std::size_t i = 0; i < words; ++i)
        addition.at_end +=
            fmt::format("    gnomon_reached[{0}u * index + {1}u] = gnomon_bits[{1}u];\n", words, i);
    return addition;
}

} // namespace gnomon::coverage
