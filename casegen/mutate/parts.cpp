#include "casegen/mutate/parts.h"

#include <algorithm>
#include <array>

namespace gnomon::mutate {
namespace {

using glsl::Token;

constexpr std::array<std::string_view, 11> assignments{
    "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};
constexpr std::array<std::string_view, 7> not_called{"if", "for", "while", "switch", "return", "else", "do"};
constexpr std::array<std::string_view, 6> qualifiers{"const",   "precise", "highp",
                                                     "mediump", "lowp",    "shared"};

bool is_one_of(std::string_view what, auto& list) { return std::ranges::find(list, what) != list.end(); }

bool opens(const Token& token) { return token.is("(") || token.is("[") || token.is("{"); }
bool closes(const Token& token) { return token.is(")") || token.is("]") || token.is("}"); }

/// The first token from `begin` on that is `what` outside of brackets; `end` if there is none.
std::size_t find_outside(const std::vector<Token>& tokens, std::size_t begin, std::size_t end,
                         std::string_view what) {
    for (std::size_t i = begin; i < end; ++i) {
        if (tokens[i].is(what)) return i;
        if (opens(tokens[i])) i = std::min(closing(tokens, i), end);
    }
    return end;
}

} // namespace

Parts::Parts(std::string_view text) : tokens_(glsl::tokens(text)) {
    const std::vector<glsl::Function> functions = glsl::functions(tokens_);
    for (const glsl::Function& function : functions) {
        regions_.push_back(region(function.type, function.end + 1, function.begin + 1, function.end));
        for (std::size_t i = function.begin + 1; i < function.end;) i = statement(i, function.end, function);
    }
    find_declarations(functions);
    std::ranges::sort(regions_, {}, &Region::begin);
    for (const Region& each : regions_) expressions(each.begin, each.end);
}

Region Parts::region(std::size_t first, std::size_t last, std::size_t begin, std::size_t end) const {
    Region result;
    result.begin = begin;
    result.end = end;
    result.first = first;
    for (std::size_t i = first; i < last; ++i) {
        if (i > first) result.text += ' ';
        result.text += tokens_[i].text;
    }
    return result;
}

const Region& Parts::region_of(std::size_t token) const {
    const auto behind = std::ranges::upper_bound(regions_, token, {}, &Region::begin);
    return *std::prev(behind);
}

bool Parts::is_binary(std::size_t token) const {
    if (token == 0) return false;
    const Token& before = tokens_[token - 1];
    if (before.kind == Token::Kind::number || before.is(")") || before.is("]")) return true;
    return before.kind == Token::Kind::identifier && !is_one_of(before.text, not_called);
}

bool Parts::is_assignment(std::size_t token) const { return is_one_of(tokens_[token].text, assignments); }

bool Parts::is_of_loop(const Value& condition) const {
    return std::ranges::find(loops_, condition) != loops_.end();
}

bool Parts::is_of_step(std::size_t token) const {
    return std::ranges::any_of(
        steps_, [token](const Value& step) { return token >= step.begin && token < step.end; });
}

/// Outside of functions and blocks: `type name = value;`.
void Parts::find_declarations(const std::vector<glsl::Function>& functions) {
    auto function = functions.begin();
    std::size_t first = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (function != functions.end() && i == function->type) {
            i = function->end;
            first = i + 1;
            ++function;
        } else if (opens(tokens_[i])) {
            i = closing(tokens_, i);
        } else if (tokens_[i].is("=")) {
            const std::size_t end = find_outside(tokens_, i, tokens_.size(), ";");
            regions_.push_back(region(first, end, i + 1, end));
            i = end;
            first = i + 1;
        } else if (tokens_[i].is(";")) {
            first = i + 1;
        }
    }
}

/// Takes note of the statement at `begin`; the token behind it.
std::size_t Parts::statement(std::size_t begin, std::size_t end, const glsl::Function& function) {
    const Token& token = tokens_[begin];
    const auto after_brackets = [&](std::size_t open) {
        return std::min(closing(tokens_, open), end - 1) + 1;
    };
    if (token.is("{")) {
        const std::size_t close = after_brackets(begin) - 1;
        for (std::size_t i = begin + 1; i < close;) i = statement(i, close, function);
        return close + 1;
    }
    if (token.is("if") || token.is("while") || token.is("switch")) {
        const std::size_t behind = after_brackets(begin + 1);
        const Value condition{begin + 2, behind - 1};
        if (!token.is("switch")) conditions_.push_back(condition);
        if (token.is("while")) loops_.push_back(condition);
        std::size_t next = statement(behind, end, function);
        if (token.is("if") && next < end && tokens_[next].is("else"))
            next = statement(next + 1, end, function);
        return next;
    }
    if (token.is("for")) {
        const std::size_t behind = after_brackets(begin + 1);
        const std::size_t first = find_outside(tokens_, begin + 2, behind - 1, ";");
        const std::size_t second = find_outside(tokens_, first + 1, behind - 1, ";");
        simple_statement(begin + 2, first);
        if (second > first + 1) {
            conditions_.push_back({first + 1, second});
            loops_.push_back({first + 1, second});
        }
        steps_.push_back({second + 1, behind - 1});
        return statement(behind, end, function);
    }
    if (token.is("do")) return statement(begin + 1, end, function); // its while stands for itself
    if (token.is("case") || token.is("default")) return find_outside(tokens_, begin, end, ":") + 1;
    const std::size_t stop = find_outside(tokens_, begin, end, ";");
    if (token.is("return")) {
        const bool is_last = stop + 1 >= function.end;
        if (stop > begin + 1) {
            values_.push_back({begin + 1, stop});
            returns_.push_back({{begin + 1, stop}, tokens_[function.type].text, function.name});
        }
        if (!is_last && stop < end) droppable_.push_back({begin, stop + 1});
        return stop + 1;
    }
    simple_statement(begin, stop);
    std::size_t type = begin;
    while (type < stop && is_one_of(tokens_[type].text, qualifiers)) ++type;
    const bool declares = type > begin || (type + 1 < stop && tokens_[type].kind == Token::Kind::identifier &&
                                           tokens_[type + 1].kind == Token::Kind::identifier);
    if (!declares && stop > begin && stop < end) droppable_.push_back({begin, stop + 1});
    return stop + 1;
}

/// Values that are assigned in it.
void Parts::simple_statement(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
        if (opens(tokens_[i])) i = std::min(closing(tokens_, i), end);
        if (i >= end || !tokens_[i].is("=")) continue;
        const std::size_t stop = find_outside(tokens_, i + 1, end, ",");
        if (stop > i + 1) values_.push_back({i + 1, stop});
        i = stop;
    }
}

/// Calls and conditional expressions.
void Parts::expressions(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
        if (tokens_[i].kind == Token::Kind::identifier && i + 1 < end && tokens_[i + 1].is("(") &&
            !is_one_of(tokens_[i].text, not_called)) {
            Call call;
            call.name = i;
            const std::size_t close = std::min(closing(tokens_, i + 1), end);
            call.end = close + 1;
            for (std::size_t from = i + 2; from < close;) {
                const std::size_t comma = find_outside(tokens_, from, close, ",");
                call.arguments.push_back({from, comma});
                from = comma + 1;
            }
            calls_.push_back(std::move(call));
        }
        if (!tokens_[i].is("?")) continue;
        Ternary ternary;
        std::size_t from = i;
        while (from > begin) {
            const Token& before = tokens_[from - 1];
            if (closes(before)) { // to the bracket that opens it
                int depth = 0;
                do {
                    --from;
                    if (closes(tokens_[from])) ++depth;
                    if (opens(tokens_[from])) --depth;
                } while (depth > 0 && from > begin);
                continue;
            }
            if (opens(before) || before.is(",") || before.is(";") || before.is("?") || before.is(":") ||
                before.is("return") || is_assignment(from - 1))
                break;
            --from;
        }
        ternary.condition = {from, i};
        std::size_t colon = i + 1;
        for (int nested = 0; colon < end; ++colon) {
            if (opens(tokens_[colon])) colon = closing(tokens_, colon);
            if (colon >= end) break;
            if (tokens_[colon].is("?")) ++nested;
            if (tokens_[colon].is(":") && nested-- == 0) break;
        }
        ternary.then = {i + 1, colon};
        std::size_t to = colon + 1;
        for (int nested = 0; to < end; ++to) {
            if (opens(tokens_[to])) {
                to = closing(tokens_, to);
                if (to >= end) break;
                continue;
            }
            if (tokens_[to].is("?")) ++nested;
            if (closes(tokens_[to]) || tokens_[to].is(",") || tokens_[to].is(";")) break;
            if (tokens_[to].is(":") && nested-- == 0) break;
        }
        ternary.otherwise = {colon + 1, std::min(to, end)};
        const auto empty = [](const Value& value) { return value.begin >= value.end; };
        if (!empty(ternary.condition) && !empty(ternary.then) && !empty(ternary.otherwise))
            ternaries_.push_back(ternary);
    }
}

} // namespace gnomon::mutate
