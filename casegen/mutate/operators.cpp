#include "casegen/mutate/operators.h"

#include "casegen/mutate/parts.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace gnomon::mutate {
namespace {

using glsl::Token;

struct Change {
    std::string_view from;
    std::vector<std::string_view> to;
};

const Change* change_of(const std::vector<Change>& changes, std::string_view what) {
    const auto found = std::ranges::find(changes, what, &Change::from);
    return found == changes.end() ? nullptr : &*found;
}

const std::vector<Change> comparisons{{"<", {"<=", ">"}},  {"<=", {"<", ">="}}, {">", {">=", "<"}},
                                      {">=", {">", "<="}}, {"==", {"!="}},      {"!=", {"=="}}};
const std::vector<Change> arithmetics{{"+", {"-"}},   {"-", {"+"}},   {"*", {"/"}},   {"/", {"*"}},
                                      {"%", {"*"}},   {"++", {"--"}}, {"--", {"++"}}, {"+=", {"-="}},
                                      {"-=", {"+="}}, {"*=", {"/="}}, {"/=", {"*="}}, {"%=", {"*="}}};
const std::vector<Change> bit_operations{{"&", {"|"}},     {"|", {"&"}},    {"^", {"|"}},   {"<<", {">>"}},
                                         {">>", {"<<"}},   {"&=", {"|="}},  {"|=", {"&="}}, {"^=", {"|="}},
                                         {"<<=", {">>="}}, {">>=", {"<<="}}};
const std::vector<Change> logics{{"&&", {"||"}}, {"||", {"&&"}}, {"^^", {"=="}}};

/// Functions by another name with the same parameters.
const std::vector<Change> renamed{{"min", {"max"}},
                                  {"max", {"min"}},
                                  {"sin", {"cos"}},
                                  {"cos", {"sin"}},
                                  {"floor", {"ceil"}},
                                  {"ceil", {"floor"}},
                                  {"any", {"all"}},
                                  {"all", {"any"}},
                                  {"equal", {"notEqual"}},
                                  {"notEqual", {"equal"}},
                                  {"lessThan", {"lessThanEqual", "greaterThan"}},
                                  {"lessThanEqual", {"lessThan", "greaterThanEqual"}},
                                  {"greaterThan", {"greaterThanEqual", "lessThan"}},
                                  {"greaterThanEqual", {"greaterThan", "lessThanEqual"}}};
/// Functions whose first arguments may stand for their value: how many.
const std::vector<std::pair<std::string_view, std::size_t>> dropped{
    {"clamp", 1}, {"min", 2},   {"max", 2},       {"abs", 1},  {"floor", 1}, {"ceil", 1},
    {"fract", 1}, {"round", 1}, {"normalize", 1}, {"sqrt", 1}, {"sign", 1},  {"trunc", 1}};
/// Functions whose value does not depend on their arguments' order.
constexpr std::array<std::string_view, 6> commutative{"min", "max", "dot", "equal", "notEqual", "distance"};

std::string number_text(double value, bool is_float) {
    std::string text = is_float ? fmt::format("{}", value) : fmt::format("{:.0f}", value);
    if (is_float && text.find_first_of(".e") == text.npos) text += ".0";
    return value < 0 ? "(" + text + ")" : text;
}

/// Other numbers in place of a number: its neighbours, double and half of it, a hundredth more.
std::vector<std::string> other_numbers(std::string_view text) {
    const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    const bool is_unsigned = text.ends_with('u') || text.ends_with('U');
    const bool is_float = !hexadecimal && text.find_first_of(".eEfF") != text.npos;
    std::vector<double> values;
    const auto add = [&](double value) {
        if (std::ranges::find(values, value) == values.end()) values.push_back(value);
    };
    if (is_float) {
        double value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_whole = value == std::floor(value) && value <= 16;
        if (is_whole) {
            add(value + 1);
            add(value - 1);
        }
        if (value != 0) {
            add(2 * value);
            add(0.5 * value);
            add(value * 1.01);
        }
    } else {
        std::uint64_t value = 0;
        const std::string_view digits = hexadecimal ? text.substr(2) : text;
        std::from_chars(digits.data(), digits.data() + digits.size(), value, hexadecimal ? 16 : 10);
        const auto number = static_cast<double>(value); // exact: 32 bits at most
        add(number + 1);
        if (value > 0 || !is_unsigned) add(number - 1);
        if (value > 1) add(2 * number);
        if (value > 1) add(std::floor(number / 2));
    }
    std::vector<std::string> texts;
    for (const double value : values) {
        std::string other = number_text(value, is_float);
        if (is_unsigned) other += 'u';
        texts.push_back(std::move(other));
    }
    return texts;
}

/// Components in other places: the next one for a single one, reversed or shifted for several.
std::vector<std::string> other_components(std::string_view text) {
    for (const std::string_view letters : {"xyzw", "rgba", "stpq"}) {
        if (text.find_first_not_of(letters) != text.npos) continue;
        if (text.size() == 1) { // x y, y x, z x, w z
            constexpr std::array<std::size_t, 4> partner{1, 0, 0, 2};
            return {std::string(1, letters[partner[letters.find(text[0])]])};
        }
        std::vector<std::string> all{{text.rbegin(), text.rend()}};
        if (text == letters.substr(0, 2)) all.emplace_back(letters.substr(2, 2));
        if (text == letters.substr(2, 2)) all.emplace_back(letters.substr(0, 2));
        std::erase(all, std::string(text));
        return all;
    }
    return {};
}

/// 0 and 1 as a type writes them; nothing for a structure.
std::vector<std::string> results(std::string_view type) {
    if (type == "float" || type == "double") return {"0.0", "1.0"};
    if (type == "int") return {"0", "1"};
    if (type == "uint") return {"0u", "1u"};
    if (type == "bool") return {"false", "true"};
    if (type.starts_with("vec")) return {fmt::format("{}(0.0)", type), fmt::format("{}(1.0)", type)};
    if (type.starts_with("ivec")) return {fmt::format("{}(0)", type), fmt::format("{}(1)", type)};
    if (type.starts_with("uvec")) return {fmt::format("{}(0u)", type), fmt::format("{}(1u)", type)};
    if (type.starts_with("bvec")) return {fmt::format("{}(false)", type), fmt::format("{}(true)", type)};
    return {};
}

/// Collects the mutations of one file.
class Collector {
public:
    explicit Collector(std::string_view text) : text_(text), parts_(text) {}

    std::vector<Mutation> run() {
        for (const Region& region : parts_.regions())
            for (std::size_t i = region.begin; i < region.end; ++i) look_at(i);
        for (const Value& value : parts_.values()) negate(value);
        for (const Value& condition : parts_.conditions()) change_condition(condition);
        for (const Ternary& ternary : parts_.ternaries()) {
            add(Operator::condition, ternary.condition, "false");
            add(Operator::condition, ternary.condition, "true");
            if (!(ternary.then == ternary.otherwise))
                add(Operator::condition, {ternary.then.begin, ternary.otherwise.end},
                    fmt::format("({}) : ({})", text_of(ternary.otherwise), text_of(ternary.then)));
        }
        for (const Call& call : parts_.calls()) change_call(call);
        for (const Value& statement : parts_.droppable()) add(Operator::statement, statement, ";");
        for (const Return& each : parts_.returns())
            for (const std::string& other : results(each.type)) add(Operator::result, each.value, other);
        return in_order();
    }

private:
    const std::vector<Token>& tokens() const { return parts_.tokens(); }
    std::string_view text_of(const Value& value) const {
        const std::size_t begin = tokens()[value.begin].begin;
        return text_.substr(begin, tokens()[value.end - 1].end() - begin);
    }

    /// Replaces the tokens of `value`.
    void add(Operator by, const Value& value, std::string after) {
        Mutation mutation;
        mutation.by = by;
        mutation.begin = tokens()[value.begin].begin;
        mutation.end = tokens()[value.end - 1].end();
        if (text_.substr(mutation.begin, mutation.end - mutation.begin) == after) return;
        mutation.line = tokens()[value.begin].line;
        const std::size_t line_begin =
            mutation.begin == 0 ? text_.npos : text_.rfind('\n', mutation.begin - 1);
        mutation.column =
            static_cast<int>(mutation.begin - (line_begin == text_.npos ? 0 : line_begin + 1)) + 1;
        const Region& region = parts_.region_of(value.begin);
        mutation.identity = fmt::format("{}\n{} {} {} {}", region.text, to_string(by),
                                        value.begin - region.first, value.end - region.first, after);
        mutation.after = std::move(after);
        mutations_.push_back(std::move(mutation));
    }
    void add_all(Operator by, const Value& value, const Change* change) {
        if (!change) return;
        for (const std::string_view other : change->to) add(by, value, std::string(other));
    }

    void look_at(std::size_t i) {
        const Token& token = tokens()[i];
        const Value here{i, i + 1};
        if (token.kind == Token::Kind::number) {
            for (std::string& other : other_numbers(token.text))
                add(Operator::constant, here, std::move(other));
            return;
        }
        if (token.kind == Token::Kind::identifier) {
            if (token.is("true")) add(Operator::constant, here, "false");
            if (token.is("false")) add(Operator::constant, here, "true");
            if (i > 0 && tokens()[i - 1].is("."))
                for (std::string& other : other_components(token.text))
                    add(Operator::component, here, std::move(other));
            return;
        }
        add_all(Operator::comparison, here, change_of(comparisons, token.text));
        add_all(Operator::logic, here, change_of(logics, token.text));
        if (token.is("!") || token.is("~")) add(Operator::logic, here, "");
        add_all(Operator::bits, here, change_of(bit_operations, token.text));
        if (token.is("-") && !parts_.is_binary(i))
            add(Operator::sign, here, "");
        else if (parts_.is_of_step(i) && (token.is("++") || token.is("--")))
            double_step(i);
        else if (parts_.is_of_step(i) && (token.is("+=") || token.is("-=")))
            return; // its number is changed
        else if (!token.is("+") || parts_.is_binary(i))
            add_all(Operator::arithmetic, here, change_of(arithmetics, token.text));
    }

    /// `++i` and `i++` go on by 2. Not by -1: that loop does not end, or when the driver wants it to, so that
    /// a clock would tell such mutants and not their results.
    void double_step(std::size_t i) {
        const bool is_before = tokens()[i + 1].kind == Token::Kind::identifier;
        const Value step = is_before ? Value{i, i + 2} : Value{i - 1, i + 1};
        add(Operator::arithmetic, step,
            fmt::format("{} {}= 2", tokens()[is_before ? i + 1 : i - 1].text, tokens()[i].text.front()));
    }

    /// A minus before a whole value, unless it begins with one, is 0 or a truth value.
    void negate(const Value& value) {
        int depth = 0;
        for (std::size_t i = value.begin; i < value.end; ++i) {
            const Token& token = tokens()[i];
            if (token.is("(") || token.is("[")) ++depth;
            if (token.is(")") || token.is("]")) --depth;
            if (depth == 0 && (change_of(comparisons, token.text) || change_of(logics, token.text))) return;
        }
        const Token& first = tokens()[value.begin];
        if (first.is("-") || first.is("!") || first.is("true") || first.is("false") ||
            first.text.starts_with("bvec"))
            return;
        if (value.end - value.begin == 1 && first.kind == Token::Kind::number &&
            first.text.find_first_of("123456789") == first.text.npos)
            return;
        add(Operator::sign, value, fmt::format("-({})", text_of(value)));
    }

    void change_condition(const Value& condition) {
        // One == or != alone is negated as a comparison.
        std::size_t comparisons_in_it = 0, equalities = 0;
        for (std::size_t i = condition.begin; i < condition.end; ++i) {
            if (change_of(comparisons, tokens()[i].text) || change_of(logics, tokens()[i].text))
                ++comparisons_in_it;
            if (tokens()[i].is("==") || tokens()[i].is("!=")) ++equalities;
        }
        if (comparisons_in_it != 1 || equalities != 1)
            add(Operator::condition, condition, fmt::format("!({})", text_of(condition)));
        add(Operator::condition, condition, "false");
        if (!parts_.is_of_loop(condition)) add(Operator::condition, condition, "true");
    }

    void change_call(const Call& call) {
        const std::string_view name = tokens()[call.name].text;
        add_all(Operator::call, {call.name, call.name + 1}, change_of(renamed, name));
        const auto given = std::ranges::find(dropped, name, &std::pair<std::string_view, std::size_t>::first);
        const Value whole{call.name, call.end};
        if (given != dropped.end())
            for (std::size_t i = 0; i < std::min(given->second, call.arguments.size()); ++i)
                add(Operator::call, whole, fmt::format("({})", text_of(call.arguments[i])));
        if (name == "clamp" && call.arguments.size() == 3) {
            const std::string_view x = text_of(call.arguments[0]);
            add(Operator::call, whole, fmt::format("max({}, {})", x, text_of(call.arguments[1])));
            add(Operator::call, whole, fmt::format("min({}, {})", x, text_of(call.arguments[2])));
        }
        if (std::ranges::find(commutative, name) != commutative.end()) return;
        // clamp(x, a, b) is min(max(x, a), b).
        for (std::size_t i = name == "clamp" ? 1 : 0; i + 1 < call.arguments.size(); ++i)
            add(Operator::arguments, {call.arguments[i].begin, call.arguments[i + 1].end},
                fmt::format("{}, {}", text_of(call.arguments[i + 1]), text_of(call.arguments[i])));
    }

    std::vector<Mutation> in_order() {
        std::ranges::stable_sort(mutations_, [](const Mutation& a, const Mutation& b) {
            return a.begin != b.begin ? a.begin < b.begin : a.by < b.by;
        });
        std::set<std::string> texts;
        std::vector<Mutation> once;
        for (Mutation& mutation : mutations_) {
            if (texts.insert(mutated(text_, mutation)).second) once.push_back(std::move(mutation));
        }
        return once;
    }

    std::string_view text_;
    Parts parts_;
    std::vector<Mutation> mutations_;
};

} // namespace

const char* to_string(Operator by) {
    switch (by) {
    case Operator::constant:
        return "constant";
    case Operator::comparison:
        return "comparison";
    case Operator::arithmetic:
        return "arithmetic";
    case Operator::bits:
        return "bits";
    case Operator::sign:
        return "sign";
    case Operator::logic:
        return "logic";
    case Operator::condition:
        return "condition";
    case Operator::component:
        return "component";
    case Operator::call:
        return "call";
    case Operator::arguments:
        return "arguments";
    case Operator::statement:
        return "statement";
    case Operator::result:
        return "result";
    case Operator::stale:
        return "stale";
    }
    return "";
}

const std::vector<Operator>& all_operators() {
    using enum Operator;
    static const std::vector<Operator> all{constant,  comparison, arithmetic, bits, sign,
                                           logic,     condition,  component,  call, arguments,
                                           statement, result,     stale};
    return all;
}

Operator parse_operator(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Operator by : all_operators()) {
        if (name == to_string(by)) return by;
        names.emplace_back(to_string(by));
    }
    throw Error("no mutation operator \"{}\"; there are: {}", name, fmt::join(names, ", "));
}

std::vector<Mutation> mutations(std::string_view text) { return Collector(text).run(); }

std::string mutated(std::string_view text, const Mutation& mutation) {
    std::string result(text.substr(0, mutation.begin));
    return result.append(mutation.after).append(text.substr(mutation.end));
}

std::string stale_version(std::string_view text, std::string_view name) {
    const Parts parts(text);
    std::string result;
    std::size_t at = 0;
    for (const Return& each : parts.returns()) {
        if (each.function != name) continue;
        const std::size_t begin = parts.tokens()[each.value.begin].begin;
        const std::size_t end = parts.tokens()[each.value.end - 1].end();
        const std::string_view value = text.substr(begin, end - begin);
        std::string other;
        if (each.type == "float")
            other = fmt::format("1.0 - ({})", value);
        else if (each.type == "bool")
            other = fmt::format("!({})", value);
        else if (each.type.starts_with("bvec"))
            other = fmt::format("not({})", value);
        else if (each.type.starts_with("vec"))
            other = fmt::format("{}(1.0) - ({})", each.type, value);
        else if (each.type == "int" || each.type == "uint" || each.type.starts_with("ivec") ||
                 each.type.starts_with("uvec"))
            other = fmt::format("~({})", value);
        else
            return {};
        result += text.substr(at, begin - at);
        result += other;
        at = end;
    }
    if (at == 0) return {};
    return result.append(text.substr(at));
}

} // namespace gnomon::mutate
