#include "casegen/fuzz/failure.h"

#include "casegen/catalogue.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace gnomon::fuzz {
namespace {

/// The family in whose decision list a kernel that looks at a mask ends; null for others.
const Family* family_of(const Case& c) {
    static const std::map<const Case*, const Family*> families = [] {
        std::map<const Case*, const Family*> found;
        for (const Family& family : catalogue())
            if (find_kernel(family, "number"))
                for (const Case& each : family.cases) found[&each] = &family;
        return found;
    }();
    const auto found = families.find(&c);
    return found == families.end() ? nullptr : found->second;
}

/// The number of the case that the texel belongs to; 0 if it is none or that is no question.
unsigned case_number(const Case& c, const Arguments& arguments) {
    const Family* family = arguments.mask ? family_of(c) : nullptr;
    if (!family || c.parameters.empty() || c.parameters.front().name != "texel") return 0;
    const glm::ivec2 texel(static_cast<int>(arguments.numbers[0]), static_cast<int>(arguments.numbers[1]));
    constexpr int far_away = 1 << 14; // no walk ends there
    if (std::abs(texel.x) > far_away || std::abs(texel.y) > far_away) return 0;
    return number_by_conditions(*family, reference::edge(*arguments.mask, texel));
}

} // namespace

std::string failure_of(const Case& c, const Arguments& arguments, std::span<const std::uint32_t> result,
                       const Agreement& agreement) {
    if (agreement.pass) return {};
    const bool inside = in_domain(c, arguments);
    std::string what = "wrong";
    for (const std::uint32_t word : result) {
        const double got = widen(c.reference.result.scalar, word);
        if (std::isnan(got))
            what = "NaN";
        else if (what == "wrong" && !(got >= c.result.lower && got <= c.result.upper))
            what = "out of range";
    }
    if (const unsigned number = inside ? case_number(c, arguments) : 0)
        what += fmt::format(" in case {}", number);
    return inside ? what : what + ", outside the domain";
}

std::vector<std::string> failures_of(const Case& c, const Records& records, const Outputs& outputs,
                                     std::span<const Truth> truths) {
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    std::vector<std::string> failures(records.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Arguments with = arguments(c, records.input(i), records.mask(i));
        const std::span<const std::uint32_t> got(outputs.words.data() + i * components, components);
        failures[i] = failure_of(c, with, got, judge(c, with, got, truths.empty() ? nullptr : &truths[i]));
    }
    return failures;
}

} // namespace gnomon::fuzz
