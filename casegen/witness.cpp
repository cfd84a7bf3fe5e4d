#include "casegen/witness.h"

#include "casegen/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace gnomon {
namespace {

/// All masks of one size, in all surrounds, and all their texels; ends when `visit` says so.
template <typename Visit>
bool for_all_masks(int width, int height, const Visit& visit) {
    const int texels = width * height;
    for (const Outside outside : {Outside::lit, Outside::shadow, Outside::clamp})
        for (std::uint32_t bits = 0; bits < (1u << texels); ++bits) {
            Mask mask(width, height, true, outside);
            for (int i = 0; i < texels; ++i) mask.texels[static_cast<std::size_t>(i)] = (bits >> i) & 1u;
            for (int i = 0; i < texels; ++i)
                if (visit(mask, glm::ivec2(i % width, i / width))) return true;
        }
    return false;
}

/// Sizes in order of their texel count, then width, within limits.
std::vector<glm::ivec2> sizes(int most_texels, int most_side) {
    std::vector<glm::ivec2> found;
    for (int texels = 1; texels <= most_texels; ++texels)
        for (int width = 1; width <= std::min(texels, most_side); ++width)
            if (texels % width == 0 && texels / width <= most_side) found.emplace_back(width, texels / width);
    return found;
}

} // namespace

std::optional<Witness> smallest_witness(const Case& c, int most_texels) {
    std::optional<Witness> found;
    for (const glm::ivec2 size : sizes(most_texels, most_texels)) {
        const bool done = for_all_masks(size.x, size.y, [&](const Mask& mask, glm::ivec2 texel) {
            if (!applies(c, reference::edge(mask, texel))) return false;
            found = Witness{mask, texel};
            return true;
        });
        if (done) break;
    }
    return found;
}

std::string to_string(const Branch& branch) {
    std::string text = branch.kernel->name;
    for (const auto& [name, value] : branch.facts) text += fmt::format(" {}={}", name, value);
    return text;
}

std::string to_string(const BranchWitness& found) {
    const auto& [mask, texel] = found.witness;
    return fmt::format("{}: {} {},{} {}", to_string(found.branch), to_string(mask.outside), texel.x, texel.y,
                       format_mask(mask, '/'));
}

std::optional<Branch> branch_of(const Family& family, const Mask& mask, glm::ivec2 texel) {
    Facts facts;
    facts.texel = texel;
    facts.edge = reference::edge(mask, texel);
    facts.mask = &mask;
    const auto found = std::ranges::find_if(
        family.cases, [&](const Case& c) { return c.number != 0 && holds(c.condition, facts.edge); });
    if (found == family.cases.end()) return {};
    Branch branch{&*found, {}};
    bool next_texel_decides = false;
    for (std::size_t i = 0; i < found->parameters.size(); ++i) {
        const std::string& name = found->parameters[i].name;
        const Fact fact = find_fact(name);
        if (found->reference.parameters[i].scalar == Scalar::float32 || !fact) continue;
        // The end of a bar looks for its breach only if the next texel has both walls.
        if (name == "breach" && next_texel_decides) continue;
        Numbers numbers{};
        const int components = fact(facts, numbers);
        for (int k = 0; k < components; ++k) {
            const int value = static_cast<int>(numbers[static_cast<std::size_t>(k)]);
            branch.facts.emplace_back(components == 1 ? name : fmt::format("{}_{}", name, "xy"[k]), value);
            if (name == "neighbour") next_texel_decides = value != static_cast<int>(reference::both);
        }
    }
    return branch;
}

std::vector<BranchWitness> branch_witnesses(const Family& family, int most_texels, int most_side) {
    std::map<Branch, Witness> found;
    for (const glm::ivec2 size : sizes(most_texels, most_side))
        for_all_masks(size.x, size.y, [&](const Mask& mask, glm::ivec2 texel) {
            if (std::optional<Branch> branch = branch_of(family, mask, texel))
                found.try_emplace(std::move(*branch), Witness{mask, texel});
            return false;
        });
    std::vector<BranchWitness> result;
    for (auto& [branch, witness] : found) result.push_back({branch, std::move(witness)});
    return result;
}

} // namespace gnomon
