#include "casegen/measure/variant.h"

#include "casegen/catalogue.h"
#include "casegen/sampling.h"
#include "casegen/standalone.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::measure {
namespace {

bool share_inputs(const Case& a, const Case& b) {
    return a.quantity == b.quantity && a.reference.parameters == b.reference.parameters &&
           a.reference.result == b.reference.result && default_seed(a) == default_seed(b);
}

/// "sinc" of "integral/sinc/a0": what is left of the name without what its siblings' names share. A kernel
/// alone keeps its whole name.
std::string short_name(const std::vector<const Case*>& cases, const std::string& name) {
    if (cases.size() == 1) return name;
    std::size_t front = name.size(), back = name.size();
    for (const Case* c : cases) {
        const std::string& other = c->name;
        const auto least = static_cast<std::ptrdiff_t>(std::min(name.size(), other.size()));
        front = std::min(front, static_cast<std::size_t>(
                                    std::mismatch(name.begin(), name.begin() + least, other.begin()).first -
                                    name.begin()));
        back = std::min(back, static_cast<std::size_t>(
                                  std::mismatch(name.rbegin(), name.rbegin() + least, other.rbegin()).first -
                                  name.rbegin()));
    }
    // Whole parts of the name only.
    while (front > 0 && name[front - 1] != '/') --front;
    while (back > 0 && name[name.size() - back] != '/') --back;
    return front + back < name.size() ? name.substr(front, name.size() - front - back) : name;
}

} // namespace

std::string to_string(Trigonometry) { return "portable"; }

Trigonometry parse_trigonometry(const std::string& text) {
    if (text != "portable") throw Error("--trigonometry is \"{}\"; there is: portable", text);
    return Trigonometry::portable;
}

glsl::Sources sources_of(const std::filesystem::path& kernels, Trigonometry) {
    return kernel_sources(kernels);
}

std::vector<Group> group(std::span<const Case* const> cases, std::span<const Trigonometry> modes) {
    std::vector<std::vector<const Case*>> alike;
    for (const Case* c : cases) {
        const auto found = std::ranges::find_if(alike, [&](const std::vector<const Case*>& others) {
            return !c->quantity.empty() && share_inputs(*c, *others.front());
        });
        if (found != alike.end())
            found->push_back(c);
        else
            alike.push_back({c});
    }
    std::vector<Group> groups;
    for (const std::vector<const Case*>& members : alike) {
        const Case& first = *members.front();
        Group made{first.quantity.empty() ? first.name : first.quantity, {}};
        const bool taken =
            std::ranges::any_of(groups, [&](const Group& other) { return other.name == made.name; });
        if (taken) made.name = first.name;
        for (const Case* c : members)
            for (const Trigonometry mode : modes) {
                const std::string name = short_name(members, c->name);
                made.variants.push_back(
                    {c, mode, modes.size() > 1 ? fmt::format("{}, {}", name, to_string(mode)) : name});
            }
        groups.push_back(std::move(made));
    }
    return groups;
}

std::vector<const Case*> find_variants(const std::string& pattern) {
    std::vector<const Case*> found;
    if (!pattern.empty())
        for (const Case* c : find_cases(""))
            if (c->quantity == pattern) found.push_back(c);
    return found.empty() ? find_cases(pattern) : found;
}

} // namespace gnomon::measure
