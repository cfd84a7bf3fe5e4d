#include "casegen/measure/variant.h"

#include "casegen/catalogue.h"
#include "casegen/pattern.h"
#include "casegen/sampling.h"
#include "casegen/standalone.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace gnomon::measure {
namespace {

bool share_inputs(const Case& a, const Case& b) {
    if (a.quantity.empty()) return a.name == b.name;
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

/// What the kernels of a quantity are asked, wherever one of them is.
Case whole(const std::vector<const Case*>& members) {
    std::vector<const Case*> all = members;
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (share_inputs(c, *members.front())) all.push_back(&c);
    Case made = *members.front();
    made.where = [all = std::move(all)](const Arguments& arguments) {
        return std::ranges::any_of(all, [&](const Case* c) { return in_domain(*c, arguments); });
    };
    return made;
}

std::vector<Trigonometry> modes_that_differ(const Case& c, std::span<const Trigonometry> modes,
                                            const std::filesystem::path& kernels) {
    if (modes.size() == 1) return {modes.front()};
    std::vector<Trigonometry> different;
    std::vector<std::string> texts;
    for (const Trigonometry mode : modes) {
        std::string text =
            glsl::expand(kernel_sources(kernels, {}, mode), standalone_source(c), standalone_name);
        if (std::ranges::find(texts, text) != texts.end()) continue;
        texts.push_back(std::move(text));
        different.push_back(mode);
    }
    return different;
}

} // namespace

std::string full_name(const Variant& variant) {
    std::string name = variant.kernel->name;
    if (variant.trigonometry != Trigonometry::portable)
        name += std::string(", ") + to_string(variant.trigonometry);
    return name;
}

std::vector<Group> group(std::span<const Case* const> cases, std::span<const Trigonometry> modes,
                         const std::filesystem::path& kernels) {
    std::vector<std::vector<const Case*>> alike;
    for (const Case* c : cases) {
        const auto found = std::ranges::find_if(
            alike, [&](const std::vector<const Case*>& others) { return share_inputs(*c, *others.front()); });
        if (found != alike.end())
            found->push_back(c);
        else
            alike.push_back({c});
    }
    std::vector<Group> groups;
    for (const std::vector<const Case*>& members : alike) {
        const Case& first = *members.front();
        Group made{first.quantity.empty() ? first.name : first.quantity, whole(members), {}};
        const bool taken =
            std::ranges::any_of(groups, [&](const Group& other) { return other.name == made.name; });
        if (taken) made.name = first.name;
        for (const Case* c : members)
            for (const Trigonometry mode : modes_that_differ(*c, modes, kernels)) {
                const std::string name = short_name(members, c->name);
                made.variants.push_back(
                    {c, mode, modes.size() > 1 ? fmt::format("{}, {}", name, to_string(mode)) : name});
            }
        groups.push_back(std::move(made));
    }
    return groups;
}

std::vector<const Case*> find_variants(const std::string& patterns) {
    std::vector<const Case*> variants = find_cases("");
    std::set<const Case*> named;
    for (const std::string& part : split_patterns(patterns)) {
        const auto is_variant = [&](const Case* c) { return !part.empty() && c->quantity == part; };
        if (std::ranges::any_of(variants, is_variant))
            std::ranges::copy_if(variants, std::inserter(named, named.end()), is_variant);
        else
            std::ranges::copy(find_cases(part), std::inserter(named, named.end()));
    }
    std::erase_if(variants, [&](const Case* c) { return !named.contains(c); });
    return variants;
}

} // namespace gnomon::measure
