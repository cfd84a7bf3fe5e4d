#include "casegen/assembly.h"

#include "casegen/catalogue.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>

namespace gnomon {
namespace {

using Cases = std::vector<const Case*>;

constexpr Condition anything{};

/// A case with what is left of its condition where some is known already.
struct Candidate {
    const Case* c;
    Conditions conditions;
};

constexpr std::array members{&Condition::light,  &Condition::side_x, &Condition::side_y,
                             &Condition::type_x, &Condition::type_y, &Condition::dominant};

Condition intersection(Condition a, const Condition& b) {
    for (const auto member : members) a.*member &= b.*member;
    return a;
}

bool is_possible(const Condition& c) {
    return std::ranges::all_of(members, [&](auto member) { return c.*member != 0; });
}

/// What remains to be asked of an edge that is known to satisfy `known`: values that it cannot have are
/// allowed where that makes the question shorter, or none.
Condition given(Condition c, const Condition& known) {
    for (const auto member : members) {
        const unsigned all = anything.*member, with = c.*member | (all & ~(known.*member));
        const auto length = [&](unsigned set) {
            return std::min(std::popcount(set), std::popcount(all & ~set));
        };
        if (length(with) < length(c.*member)) c.*member = with;
    }
    return c;
}

/// A question that parts a chain of cases in two. Either answer is a union of conditions.
struct Split {
    const char* test;
    std::vector<Condition> yes, no;
};

const std::vector<Split>& splits() {
    constexpr unsigned not_both = sets::any_side & ~sets::both;
    static const std::vector<Split> all{
        {"edge.lit", {{.light = sets::lit}}, {{.light = sets::shadowed}}},
        {"edge.sides.x == BOTH || edge.sides.y == BOTH",
         {{.side_x = sets::both}, {.side_y = sets::both}},
         {{.side_x = not_both, .side_y = not_both}}},
    };
    return all;
}

/// The candidates that one answer leaves, each without the conjunctions that contradict it.
std::vector<Candidate> agreeing(const std::vector<Candidate>& candidates,
                                const std::vector<Condition>& answer, const Condition& known) {
    std::vector<Candidate> found;
    for (const Candidate& candidate : candidates) {
        Conditions left;
        for (const Condition& c : candidate.conditions)
            if (std::ranges::any_of(answer, [&](const Condition& a) {
                    return is_possible(intersection(intersection(c, a), known));
                }))
                left.push_back(c);
        if (!left.empty()) found.push_back({candidate.c, left});
    }
    return found;
}

struct Writer {
    const Family& family;
    const Assembly& assembly;
    std::string prefix; // "smsr"
    Cases held, left_out;
    std::string text{};

    void line(int depth, const std::string& what) {
        text += std::string(static_cast<std::size_t>(4 * depth), ' ') + what + '\n';
    }

    std::string question(const std::string& condition) const {
        return assembly.count_tests ? fmt::format("condition_tested({})", condition) : condition;
    }

    static std::string call(const Case& c) {
        std::vector<std::string> names;
        for (const Parameter& p : c.parameters) names.push_back(p.name);
        return fmt::format("{}({})", function_name(c), fmt::join(names, ", "));
    }

    std::vector<Candidate> candidates() const {
        std::vector<Candidate> all;
        for (const Case* c : held) all.push_back({c, c->condition});
        return all;
    }

    void chain(const std::vector<Candidate>& links, const Condition& known, int depth) {
        for (const Candidate& link : links) {
            Conditions conditions;
            for (const Condition& c : link.conditions) conditions.push_back(given(c, known));
            line(depth, fmt::format("if ({}) return {};", question(to_glsl(conditions)), call(*link.c)));
        }
    }

    void tree(const std::vector<Candidate>& links, const Condition& known, std::size_t split, int depth) {
        if (split == splits().size()) return chain(links, known, depth);
        const Split& s = splits()[split];
        const std::vector<Candidate> yes = agreeing(links, s.yes, known), no = agreeing(links, s.no, known);
        if (yes.empty() || no.empty()) return tree(links, known, split + 1, depth);
        const auto branch = [&](const std::vector<Candidate>& taken, const std::vector<Condition>& answer) {
            tree(taken, answer.size() == 1 ? intersection(known, answer.front()) : known, split + 1,
                 depth + 1);
        };
        line(depth, fmt::format("if ({}) {{", question(s.test)));
        branch(yes, s.yes);
        line(depth, "} else {");
        branch(no, s.no);
        line(depth, "}");
    }

    /// What a texel of no case gives: its shadow test.
    static constexpr const char* shadow_test = "edge.lit ? 1.0 : 0.0";

    void choose_by_number() {
        line(1, "switch (number) {");
        for (const Case* c : held) line(1, fmt::format("case {}u: return {};", c->number, call(*c)));
        line(1, "}");
    }

    void evaluate_all() {
        line(1, fmt::format("float result = {};", shadow_test));
        for (const Case* c : held) line(1, fmt::format("float value_{} = {};", c->number, call(*c)));
        for (const Case* c : held)
            line(1, fmt::format("bool holds_{} = {};", c->number, question(to_glsl(c->condition))));
        for (const Case* c : held)
            line(1, fmt::format("result = holds_{0} ? value_{0} : result;", c->number));
        if (!left_out.empty()) {
            std::string none;
            for (const Case* c : held) none += fmt::format("!holds_{} && ", c->number);
            line(1, fmt::format("case_left_out = {}number != 0u;", none));
        }
        line(1, "return result;");
    }

    /// Only the decision list's number tells a texel of no case from one of a case that is left out.
    void end_without_a_case() {
        if (!left_out.empty()) line(1, "case_left_out = number != 0u;");
        line(1, fmt::format("return {};", shadow_test));
    }

    // The table holds four numbers a word; facts are digits, the first one varies fastest.

    static constexpr std::size_t table_size = 2 * 4 * 4 * 3 * 3 * 4;

    unsigned number_at(std::size_t index) const {
        const auto digit = [&](std::size_t base) {
            const std::size_t value = index % base;
            index /= base;
            return static_cast<unsigned>(value);
        };
        reference::Edge edge;
        edge.lit = digit(2) == 1;
        edge.sides.x = digit(4);
        edge.sides.y = digit(4);
        edge.type.x = static_cast<int>(digit(3)) - 1;
        edge.type.y = static_cast<int>(digit(3)) - 1;
        const unsigned dominant = digit(4);
        edge.dominant = {(dominant & 1u) != 0, (dominant & 2u) != 0};
        for (const Cases* cases : {&held, &left_out})
            for (const Case* c : *cases)
                if (holds(c->condition, edge)) return c->number;
        return 0;
    }

    void write_table() {
        std::vector<std::string> words;
        for (std::size_t i = 0; i < table_size; i += 4) {
            unsigned word = 0;
            for (unsigned k = 0; k < 4; ++k) word |= number_at(i + k) << 8 * k;
            words.push_back(fmt::format("0x{:x}u", word));
        }
        text += fmt::format("const uint {}_numbers[{}] = {{{}}};\n", prefix, words.size(),
                            fmt::join(words, ", "));
    }

    void look_up() {
        line(1, "uint dominant_bits = (edge.dominant.x ? 1u : 0u) + (edge.dominant.y ? 2u : 0u);");
        line(1, "uint types = uint(edge.type.x + 1) + 3u * (uint(edge.type.y + 1) + 3u * dominant_bits);");
        line(1,
             "uint index = (edge.lit ? 1u : 0u) + 2u * (edge.sides.x + 4u * (edge.sides.y + 4u * types));");
        line(1, fmt::format("number = ({}_numbers[index >> 2] >> (8u * (index & 3u))) & 255u;", prefix));
    }

    void body() {
        switch (assembly.variant) {
        case Variant::switch_by_number:
            choose_by_number();
            return end_without_a_case();
        case Variant::table:
            look_up();
            choose_by_number();
            return end_without_a_case();
        case Variant::document_order:
        case Variant::frequency_order:
            chain(candidates(), anything, 1);
            return end_without_a_case();
        case Variant::branch_tree:
            tree(candidates(), anything, 0, 1);
            return end_without_a_case();
        case Variant::branchless:
            return evaluate_all();
        }
    }

    std::string write() {
        text += "#include \"revectorize/edge.glslh\"\n#include \"revectorize/left_out.glslh\"\n";
        Cases included = held;
        std::ranges::sort(included, {}, &Case::number);
        for (const Case* c : included) text += fmt::format("#include \"{}.glsl\"\n", c->name);
        text += '\n';
        std::string parameters;
        for (const CaseParameter& p : case_parameters(family, assembly)) {
            text += fmt::format("const bool {}_needs_{} = {};\n", prefix, p.name, p.needed);
            parameters += fmt::format(", {} {}", p.type, p.name);
        }
        if (assembly.count_tests)
            text += "uint conditions_tested = 0u;\n"
                    "bool condition_tested(bool holds) {\n    ++conditions_tested;\n    return holds;\n}\n";
        if (assembly.variant == Variant::table) write_table();
        line(0, fmt::format("float {}_case(uint number, Edge edge{}) {{", prefix, parameters));
        body();
        line(0, "}");
        return std::move(text);
    }
};

/// Throws Error unless the family has every number that the assembly names.
void require_numbers(const Family& family, const Assembly& assembly) {
    for (const unsigned number : assembly.cases)
        if (number != 0 && std::ranges::find(family.cases, number, &Case::number) == family.cases.end())
            throw Error("{} has no case {}", family.name, number);
}

} // namespace

const char* to_string(Variant variant) {
    switch (variant) {
    case Variant::document_order:
        return "document";
    case Variant::frequency_order:
        return "frequency";
    case Variant::branch_tree:
        return "tree";
    case Variant::branchless:
        return "branchless";
    case Variant::table:
        return "table";
    case Variant::switch_by_number:
        break;
    }
    return "switch";
}

const std::vector<Variant>& all_variants() {
    static const std::vector<Variant> all{Variant::switch_by_number, Variant::document_order,
                                          Variant::frequency_order,  Variant::branch_tree,
                                          Variant::branchless,       Variant::table};
    return all;
}

std::vector<const Case*> numbered_cases(const Family& family) {
    Cases numbered;
    for (const Case& c : family.cases)
        if (c.number != 0) numbered.push_back(&c);
    std::ranges::sort(numbered, {}, &Case::number);
    return numbered;
}

std::vector<const Case*> held_cases(const Family& family, const Assembly& assembly) {
    require_numbers(family, assembly);
    const Cases all = numbered_cases(family);
    if (assembly.cases.empty()) return all;
    Cases held;
    for (const unsigned number : assembly.cases)
        if (const auto found = std::ranges::find(all, number, &Case::number);
            found != all.end() && std::ranges::find(held, *found) == held.end())
            held.push_back(*found);
    if (assembly.variant == Variant::document_order) std::ranges::sort(held, {}, &Case::number);
    return held;
}

std::vector<const Case*> left_out_cases(const Family& family, const Assembly& assembly) {
    const Cases held = held_cases(family, assembly);
    Cases left_out = numbered_cases(family);
    std::erase_if(left_out, [&](const Case* c) { return std::ranges::find(held, c) != held.end(); });
    return left_out;
}

std::vector<CaseParameter> case_parameters(const Family& family, const Assembly& assembly) {
    std::map<std::string, CaseParameter> parameters;
    for (const Case* c : numbered_cases(family))
        for (std::size_t i = 0; i < c->parameters.size(); ++i) {
            const std::string& name = c->parameters[i].name;
            parameters[name] = {name, glsl_name(c->reference.parameters[i])};
        }
    for (const Case* c : held_cases(family, assembly))
        for (const Parameter& p : c->parameters) parameters[p.name].needed = true;
    std::vector<CaseParameter> result;
    for (const auto& [name, parameter] : parameters) result.push_back(parameter);
    return result;
}

std::string assembled(const Family& family, const Assembly& assembly) {
    return Writer{family, assembly, identifier(family), held_cases(family, assembly),
                  left_out_cases(family, assembly)}
        .write();
}

} // namespace gnomon
