#include "casegen/atlas/mathml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace gnomon::atlas {
namespace {

struct Value {
    unsigned bit; ///< in the condition's set
    const char* mathml;
};

/// A member with the numbers that the documents give its values, in their order.
struct Member {
    unsigned Condition::*set;
    const char* mathml;
    std::vector<Value> values;
};

// 0.25 means PLUS along x and MINUS along y: as the documents print it.
const std::vector<Member>& members() {
    static const std::vector<Member> all{
        {&Condition::light,
         "<msub><mi>s</mi><mi>c</mi></msub>",
         {{sets::shadowed, "<mn>0</mn>"}, {sets::lit, "<mn>1</mn>"}}},
        {&Condition::side_x,
         "<msub><mi>d</mi><mi>c.r</mi></msub>",
         {{sets::neither, "<mn>0</mn>"},
          {sets::plus, "<mn>0.25</mn>"},
          {sets::minus, "<mn>0.5</mn>"},
          {sets::both, "<mn>0.75</mn>"}}},
        {&Condition::side_y,
         "<msub><mi>d</mi><mi>c.g</mi></msub>",
         {{sets::neither, "<mn>0</mn>"},
          {sets::minus, "<mn>0.25</mn>"},
          {sets::plus, "<mn>0.5</mn>"},
          {sets::both, "<mn>0.75</mn>"}}},
        {&Condition::type_x,
         "<msub><mi>t</mi><mi>h</mi></msub>",
         {{sets::open, "<mrow><mo form=\"prefix\">−</mo><mn>1</mn></mrow>"},
          {sets::one_end, "<mn>0</mn>"},
          {sets::closed, "<mn>1</mn>"}}},
        {&Condition::type_y,
         "<msub><mi>t</mi><mi>v</mi></msub>",
         {{sets::open, "<mrow><mo form=\"prefix\">−</mo><mn>1</mn></mrow>"},
          {sets::one_end, "<mn>0</mn>"},
          {sets::closed, "<mn>1</mn>"}}},
    };
    return all;
}

/// "= a", "≠ a" where that excludes but one, "∈ {a, b}", "∈ ∅".
std::string relation(const std::vector<Value>& values, unsigned set) {
    std::vector<const char*> in, out;
    for (const Value& value : values) ((set & value.bit) != 0 ? in : out).push_back(value.mathml);
    if (in.size() == 1) return fmt::format("<mo>=</mo>{}", in.front());
    if (out.size() == 1) return fmt::format("<mo>≠</mo>{}", out.front());
    if (in.empty()) return "<mo>∈</mo><mi>∅</mi>";
    return fmt::format("<mo>∈</mo><mrow><mo>{{</mo>{}<mo>}}</mo></mrow>",
                       fmt::join(in, "<mo separator=\"true\">,</mo>"));
}

constexpr const char* goes_on_r = "<msub><mi>D</mi><mi>r</mi></msub>";
constexpr const char* goes_on_g = "<msub><mi>D</mi><mi>g</mi></msub>";

/// The set of pairs as what it says of each edge, or of both together.
std::vector<std::string> dominance(unsigned set) {
    using namespace sets;
    const auto one_is = [](const char* edge, int value) {
        return fmt::format("{}<mo>=</mo><mn>{}</mn>", edge, value);
    };
    const auto together = [](const char* sign, const char* right) {
        return std::vector{fmt::format("{}{}{}{}", goes_on_r, sign, goes_on_g, right)};
    };
    switch (set) {
    case any_dominance:
        return {};
    case ends_both | goes_on_both:
        return together("<mo>=</mo>", "");
    case goes_on_x | goes_on_y:
        return together("<mo>≠</mo>", "");
    case goes_on_x | goes_on_y | goes_on_both:
        return together("<mo>+</mo>", "<mo>≥</mo><mn>1</mn>");
    case ends_both | goes_on_x | goes_on_y:
        return together("<mo>+</mo>", "<mo>≤</mo><mn>1</mn>");
    case ends_both | goes_on_x | goes_on_both:
        return together("<mo>≥</mo>", "");
    case ends_both | goes_on_y | goes_on_both:
        return together("<mo>≤</mo>", "");
    case 0:
        return {fmt::format("{}<mo>∈</mo><mi>∅</mi>", goes_on_r)};
    default:
        break;
    }
    std::vector<std::string> parts; // one or two pairs of the four, that share a number
    const unsigned with_x = goes_on_x | goes_on_both, with_y = goes_on_y | goes_on_both;
    if ((set & with_x) == 0 || (set & ~with_x) == 0) parts.push_back(one_is(goes_on_r, (set & with_x) != 0));
    if ((set & with_y) == 0 || (set & ~with_y) == 0) parts.push_back(one_is(goes_on_g, (set & with_y) != 0));
    return parts;
}

std::string conjunction(const Condition& condition) {
    std::vector<std::string> parts;
    for (const Member& member : members()) {
        unsigned all = 0;
        for (const Value& value : member.values) all |= value.bit;
        if (condition.*member.set != all)
            parts.push_back(member.mathml + relation(member.values, condition.*member.set));
    }
    for (std::string& part : dominance(condition.dominant)) parts.push_back(std::move(part));
    if (parts.empty()) return "<mtext>always</mtext>";
    for (std::string& part : parts) part = "<mrow>" + part + "</mrow>";
    return fmt::format("{}", fmt::join(parts, "<mo>∧</mo>"));
}

} // namespace

std::string condition_to_mathml(const Conditions& conditions) {
    std::string rows;
    for (const Condition& condition : conditions)
        rows += fmt::format("<mtr><mtd>{}</mtd><mtd><mrow>{}</mrow></mtd></mtr>",
                            rows.empty() ? "" : "<mo>∨</mo>", conjunction(condition));
    if (conditions.size() == 1)
        rows = "<mrow>" + conjunction(conditions.front()) + "</mrow>";
    else
        rows = "<mtable>" + rows + "</mtable>";
    return "<math displaystyle=\"true\">" + rows + "</math>";
}

} // namespace gnomon::atlas
