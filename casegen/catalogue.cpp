#include "casegen/catalogue.h"

#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

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
        std::vector<Family> all{revectorize_family(),     nsm_family(),        smsr_family(), rsmss_family(),
                                rbsm_silhouette_family(), rbsm_filter_family()};
        for ([[maybe_unused]] const Family& family : all)
            for ([[maybe_unused]] const Case& c : family.cases)
                assert(c.parameters.size() == c.reference.parameters.size() &&
                       "a parameter is missing in the table");
        return all;
    }();
    return families;
}

std::vector<const Case*> find_cases(const std::string& pattern) {
    const bool glob = pattern.find_first_of("*?[") != std::string::npos;
    std::vector<const Case*> found;
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (glob ? fnmatch(pattern.c_str(), c.name.c_str(), 0) == 0
                     : c.name.find(pattern) != std::string::npos)
                found.push_back(&c);
    if (found.empty()) throw unknown_kernel(pattern);
    return found;
}

const Case& find_case(const std::string& name) {
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (c.name == name) return c;
    throw unknown_kernel(name);
}

std::vector<std::string> visibility_techniques() {
    std::vector<std::string> names;
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (c.name == family.name + "/visibility") names.push_back(family.name);
    return names;
}

std::map<std::string, std::string> generated_sources() {
    std::map<std::string, std::string> sources;
    for (const Family& family : catalogue()) {
        std::string includes, calls;
        std::map<std::string, std::string>
            declared; // name to type: alphabetical, so that a new case moves nothing
        for (const Case& c : family.cases) {
            if (c.number == 0) continue;
            std::vector<std::string> names;
            for (std::size_t i = 0; i < c.parameters.size(); ++i) {
                names.push_back(c.parameters[i].name);
                declared[c.parameters[i].name] = glsl_name(c.reference.parameters[i]);
            }
            includes += fmt::format("#include \"{}.glsl\"\n", c.name);
            calls += fmt::format("    case {}u: return {}({});\n", c.number, function_name(c),
                                 fmt::join(names, ", "));
        }
        if (calls.empty()) continue;
        std::string parameters;
        for (const auto& [name, type] : declared) parameters += fmt::format(", {} {}", type, name);
        std::string prefix = family.name;
        std::ranges::replace(prefix, '/', '_');
        sources[family.name + "/cases"] = fmt::format(
            "{}\nfloat {}_case(uint number{}) {{\n    switch (number) {{\n{}    }}\n    return 1.0;\n}}\n",
            includes, prefix, parameters, calls);
    }
    return sources;
}

} // namespace gnomon
