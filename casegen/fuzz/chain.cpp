#include "casegen/fuzz/chain.h"

#include "casegen/check.h"
#include "casegen/fuzz/mask_chain.h"
#include "casegen/fuzz/scene_chain.h"
#include "casegen/hybrid/certain.h"
#include "casegen/pattern.h"

#include <algorithm>

namespace gnomon::fuzz {

const std::vector<Chain>& chains() {
    static const std::vector<Chain> all = [] {
        std::vector<Chain> made;
        for (const std::string& technique : numbered_techniques())
            made.push_back(mask_chain(technique_family(technique)));
        for (const std::string& technique : hybrid::sound_techniques())
            made.push_back(scene_chain(technique));
        return made;
    }();
    return all;
}

const Chain* find_chain(const Case& c) {
    const auto found =
        std::ranges::find_if(chains(), [&](const Chain& chain) { return &chain.described == &c; });
    return found == chains().end() ? nullptr : &*found;
}

const Case* find_subject(const std::string& name) {
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (c.name == name) return &c;
    for (const Chain& chain : chains())
        if (chain.described.name == name) return &chain.described;
    return nullptr;
}

std::vector<const Case*> find_chains(const std::string& patterns) {
    std::vector<const Case*> found;
    for (const Chain& chain : chains())
        if (matches(chain.described.name, patterns)) found.push_back(&chain.described);
    return found;
}

std::vector<const Case*> find_subjects(const std::string& patterns) {
    for (const std::string& part : split_patterns(patterns))
        if (find_chains(part).empty()) find_cases(part); // which says what there is
    std::vector<const Case*> found = find_cases("");
    std::erase_if(found, [&](const Case* c) { return !matches(c->name, patterns); });
    const std::vector<const Case*> of_chains = find_chains(patterns);
    found.insert(found.end(), of_chains.begin(), of_chains.end());
    return found;
}

std::string format_input(const Case& c, const Input& input) {
    if (const Chain* chain = find_chain(c)) return chain->format(input);
    return format_call(c, input.words, c.reference.takes_mask ? &input.mask : nullptr);
}

} // namespace gnomon::fuzz
