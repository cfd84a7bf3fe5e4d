#include "casegen/condition.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

/// One member of a condition: what it is called and what its values are called.
struct Member {
    unsigned Condition::*set;
    const char* glsl;
    std::vector<const char*> values;
};

const std::array<Member, 6>& members() {
    static const std::vector<const char*> sides{"NEITHER", "MINUS", "PLUS", "BOTH"}, types{"-1", "0", "1"};
    static const std::array<Member, 6> all{{
        {&Condition::light, "edge.lit", {"false", "true"}},
        {&Condition::side_x, "edge.sides.x", sides},
        {&Condition::side_y, "edge.sides.y", sides},
        {&Condition::type_x, "edge.type.x", types},
        {&Condition::type_y, "edge.type.y", types},
        {&Condition::dominant,
         "edge.dominant",
         {"bvec2(false, false)", "bvec2(true, false)", "bvec2(false, true)", "bvec2(true, true)"}},
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
        parts.push_back(fmt::format("{} {} {}", member.glsl, negate ? "!=" : "==", member.values[i]));
    const std::string text = fmt::format("{}", fmt::join(parts, negate ? " && " : " || "));
    return parts.size() > 1 && !negate ? "(" + text + ")" : text;
}

bool contains(unsigned set, unsigned value) { return (set >> value & 1u) != 0; }

/// "towards +y": what a set of sides along one axis says; nothing if it says nothing.
std::string sides_in_words(unsigned set, const char* axis) {
    using namespace sets;
    const auto words = [&](const char* text) { return fmt::format(fmt::runtime(text), axis); };
    switch (set) {
    case any_side:
        return {};
    case neither:
        return words("along {0}");
    case minus:
        return words("towards -{0}");
    case plus:
        return words("towards +{0}");
    case both:
        return words("towards both -{0} and +{0}");
    case one:
        return words("towards either -{0} or +{0}");
    case some:
        return words("towards -{0}, +{0} or both");
    case minus | both:
        return words("towards -{0}, perhaps +{0} too");
    case plus | both:
        return words("towards +{0}, perhaps -{0} too");
    case neither | minus:
        return words("along {0} at most towards -{0}");
    case neither | plus:
        return words("along {0} at most towards +{0}");
    case neither | one:
        return words("along {0} on one side at most");
    case neither | both:
        return words("along {0} on both sides or none");
    case neither | minus | both:
        return words("along {0} not towards +{0} alone");
    case neither | plus | both:
        return words("along {0} not towards -{0} alone");
    default:
        return words("along {0} on no possible side");
    }
}

/// "the run along x ends once".
std::string type_in_words(unsigned set, const char* axis) {
    static const std::array<const char*, 8> words{
        "is impossible",  "is open",           "ends once",          "ends at most once",
        "ends both ways", "is open or closed", "ends at least once", ""};
    if (set == sets::any_type) return {};
    return fmt::format("the run along {} {}", axis, words.at(set));
}

std::string dominance_in_words(unsigned set) {
    static const std::array<const char*, 16> words{
        "nothing is possible beyond the corner",
        "neither edge goes on beyond the corner",
        "only the x side's edge goes on beyond the corner",
        "the y side's edge ends at the corner",
        "only the y side's edge goes on beyond the corner",
        "the x side's edge ends at the corner",
        "exactly one edge goes on beyond the corner",
        "not both edges go on beyond the corner",
        "both edges go on beyond the corner",
        "both edges or neither go on beyond the corner",
        "the x side's edge goes on beyond the corner",
        "the y side's edge goes on beyond the corner only with the x side's",
        "the y side's edge goes on beyond the corner",
        "the x side's edge goes on beyond the corner only with the y side's",
        "at least one edge goes on beyond the corner",
        ""};
    return words.at(set & sets::any_dominance);
}

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

std::string in_words(const Condition& c) {
    const bool known = c.light == sets::lit || c.light == sets::shadowed;
    const char* other = c.light == sets::lit ? "shadow" : known ? "light" : "change";
    std::vector<std::string> sides, parts;
    for (const bool none : {false, true}) // "shadow towards +y and none along x", whichever the axis
        for (const char* axis : {"x", "y"}) {
            const unsigned set = *axis == 'x' ? c.side_x : c.side_y;
            if ((set == sets::neither) != none) continue;
            const std::string words = sides_in_words(set, axis);
            if (words.empty()) continue;
            if (sides.empty())
                sides.push_back(fmt::format("{}{} {}", none ? "no " : "", other, words));
            else
                sides.push_back((none ? "none " : "") + words);
        }
    parts.push_back(c.light == sets::lit ? "a lit texel" : known ? "a shadowed texel" : "a texel");
    if (c.light == 0) parts.back() = "no texel";
    if (!sides.empty()) parts.back() += fmt::format(" with {}", fmt::join(sides, " and "));
    for (std::string words :
         {type_in_words(c.type_x, "x"), type_in_words(c.type_y, "y"), dominance_in_words(c.dominant)})
        if (!words.empty()) parts.push_back(std::move(words));
    return fmt::format("{}", fmt::join(parts, "; "));
}

std::string in_words(const Conditions& conditions) {
    std::vector<std::string> alternatives;
    for (const Condition& c : conditions) alternatives.push_back(in_words(c));
    return fmt::format("{}", fmt::join(alternatives, "; or "));
}

} // namespace gnomon
