#include "casegen/condition.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

struct Value {
    const char *glsl, *words;
};

/// One member of a condition: what it is called and what its values are called.
struct Member {
    unsigned Condition::*set;
    const char *glsl, *words;
    std::vector<Value> values;
};

const std::array<Member, 6>& members() {
    static const std::vector<Value> sides{
        {"NEITHER", "neither"}, {"MINUS", "minus"}, {"PLUS", "plus"}, {"BOTH", "both"}};
    static const std::vector<Value> types{{"-1", "open"}, {"0", "with one end"}, {"1", "closed"}};
    static const std::array<Member, 6> all{{
        {&Condition::light, "edge.lit", "the texel is", {{"false", "shadowed"}, {"true", "lit"}}},
        {&Condition::side_x, "edge.sides.x", "sides along x:", sides},
        {&Condition::side_y, "edge.sides.y", "sides along y:", sides},
        {&Condition::type_x, "edge.type.x", "the run along x is", types},
        {&Condition::type_y, "edge.type.y", "the run along y is", types},
        {&Condition::dominant,
         "edge.dominant",
         "beyond the corner goes on:",
         {{"bvec2(false, false)", "neither edge"},
          {"bvec2(true, false)", "the x side's edge"},
          {"bvec2(false, true)", "the y side's edge"},
          {"bvec2(true, true)", "both edges"}}},
    }};
    return all;
}

unsigned all_of(const Member& member) { return (1u << member.values.size()) - 1; }

std::vector<std::size_t> members_of(unsigned set, std::size_t count) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < count; ++i)
        if ((set >> i & 1u) != 0) found.push_back(i);
    return found;
}

/// The shorter of "one of these" and "none of the others".
std::string set_to_glsl(const Member& member, unsigned set) {
    const std::size_t count = member.values.size();
    const std::vector<std::size_t> in = members_of(set, count), out = members_of(~set, count);
    const bool negate = out.size() < in.size();
    std::vector<std::string> parts;
    for (const std::size_t i : negate ? out : in)
        parts.push_back(fmt::format("{} {} {}", member.glsl, negate ? "!=" : "==", member.values[i].glsl));
    const std::string text = fmt::format("{}", fmt::join(parts, negate ? " && " : " || "));
    return parts.size() > 1 && !negate ? "(" + text + ")" : text;
}

bool contains(unsigned set, unsigned value) { return (set >> value & 1u) != 0; }

} // namespace

bool holds(const Condition& c, const reference::Edge& edge) {
    const unsigned dominant = (edge.dominant.x ? 1u : 0u) + (edge.dominant.y ? 2u : 0u);
    return contains(c.light, edge.lit ? 1 : 0) && contains(c.side_x, edge.sides.x) &&
           contains(c.side_y, edge.sides.y) && contains(c.type_x, static_cast<unsigned>(edge.type.x + 1)) &&
           contains(c.type_y, static_cast<unsigned>(edge.type.y + 1)) && contains(c.dominant, dominant);
}

bool holds(const Conditions& conditions, const reference::Edge& edge) {
    return std::ranges::any_of(conditions, [&](const Condition& c) { return holds(c, edge); });
}

std::string to_glsl(const Conditions& conditions) {
    std::vector<std::string> alternatives;
    for (const Condition& c : conditions) {
        std::vector<std::string> parts;
        for (const Member& member : members())
            if (c.*member.set != all_of(member)) parts.push_back(set_to_glsl(member, c.*member.set));
        alternatives.push_back(parts.empty() ? "true" : fmt::format("{}", fmt::join(parts, " && ")));
    }
    if (alternatives.size() == 1) return alternatives.front();
    for (std::string& alternative : alternatives) alternative = "(" + alternative + ")";
    return fmt::format("{}", fmt::join(alternatives, " || "));
}

std::string in_words(const Conditions& conditions) {
    std::vector<std::string> alternatives;
    for (const Condition& c : conditions) {
        std::vector<std::string> parts;
        for (const Member& member : members()) {
            if (c.*member.set == all_of(member)) continue;
            std::vector<std::string> values;
            for (const std::size_t i : members_of(c.*member.set, member.values.size()))
                values.emplace_back(member.values[i].words);
            parts.push_back(fmt::format("{} {}", member.words, fmt::join(values, " or ")));
        }
        alternatives.push_back(parts.empty() ? "always" : fmt::format("{}", fmt::join(parts, "; ")));
    }
    return fmt::format("{}", fmt::join(alternatives, "; or "));
}

} // namespace gnomon
