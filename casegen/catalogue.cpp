#include "casegen/catalogue.h"

#include "casegen/pattern.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

namespace gnomon {
namespace {

/// Insertions, deletions and replacements that turn one word into the other (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}

Error unknown_kernel(const std::string& name) {
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            near.emplace_back(std::min(edit_distance(name, c.name),
                                       edit_distance(name, c.name.substr(family.name.size() + 1))),
                              c.name);
    std::ranges::stable_sort(near, {}, &std::pair<std::size_t, std::string>::first);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, near.size()); ++i) names.push_back(near[i].second);
    return Error("no kernel matches \"{}\"; near names: {} (gnomon list shows all)", name,
                 fmt::join(names, ", "));
}

} // namespace

const std::vector<Family>& catalogue() {
    static const std::vector<Family> families = [] {
        std::vector<Family> all{
            revectorize_family(),     nsm_family(),         smsr_family(),         rsmss_family(),
            rbsm_silhouette_family(), rbsm_filter_family(), conservative_family(), adjacency_family(),
            certainty_family(),       column_family()};
        for (Family& family : integral_families()) all.push_back(std::move(family));
        for ([[maybe_unused]] const Family& family : all)
            for ([[maybe_unused]] const Case& c : family.cases)
                assert(c.parameters.size() == c.reference.parameters.size() &&
                       "a parameter is missing in the table");
        return all;
    }();
    return families;
}

std::vector<const Case*> find_cases(const std::string& patterns) {
    std::vector<const Case*> cases;
    for (const Family& family : catalogue())
        for (const Case& c : family.cases) cases.push_back(&c);
    for (const std::string& part : split_patterns(patterns))
        if (std::ranges::none_of(cases, [&](const Case* c) { return matches(c->name, part); }))
            throw unknown_kernel(part);
    std::erase_if(cases, [&](const Case* c) { return !matches(c->name, patterns); });
    return cases;
}

unsigned number_by_conditions(const Family& family, const reference::Edge& edge) {
    unsigned number = 0;
    for (const Case& c : family.cases)
        if (c.number != 0 && holds(c.condition, edge)) number = number == 0 ? c.number : 99;
    return number;
}

const Case& find_case(const std::string& name) {
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (c.name == name) return c;
    throw unknown_kernel(name);
}

std::string identifier(const Family& family) {
    std::string name = family.name;
    std::ranges::replace(name, '/', '_');
    return name;
}

std::string technique_name(const Family& family) {
    std::string name = family.name;
    std::ranges::replace(name, '/', '-');
    return name;
}

const Case* find_kernel(const Family& family, const std::string& name) {
    for (const Case& c : family.cases)
        if (c.name == family.name + "/" + name) return &c;
    return nullptr;
}

std::vector<std::string> visibility_techniques() {
    std::vector<std::string> names;
    for (const Family& family : catalogue())
        if (find_kernel(family, "visibility")) names.push_back(technique_name(family));
    return names;
}

std::vector<std::string> numbered_techniques() {
    std::vector<std::string> names = visibility_techniques();
    std::erase_if(names,
                  [](const std::string& name) { return !find_kernel(technique_family(name), "number"); });
    return names;
}

const Family& technique_family(const std::string& technique) {
    for (const Family& family : catalogue())
        if (technique_name(family) == technique) return family;
    throw Error("no technique \"{}\"; there are: {}", technique, fmt::join(visibility_techniques(), ", "));
}

std::map<std::string, std::string> generated_sources(const std::map<std::string, Assembly>& assemblies) {
    std::map<std::string, std::string> sources;
    for (const Family& family : catalogue()) {
        if (numbered_cases(family).empty()) continue;
        const auto found = assemblies.find(family.name);
        sources[family.name + "/cases"] =
            assembled(family, found == assemblies.end() ? Assembly{} : found->second);
    }
    for (const auto& [name, assembly] : assemblies)
        if (!sources.contains(name + "/cases")) throw Error("no family \"{}\" with numbered cases", name);
    return sources;
}

} // namespace gnomon
