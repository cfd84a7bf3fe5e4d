#include "casegen/composition.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace gnomon {
namespace {

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

/// Whether any numbered case applies to shadowed texels: else they stay dark.
bool looks_at_shadow(const Family& family) {
    return std::ranges::any_of(family.cases, [](const Case& c) {
        return c.number != 0 && std::ranges::any_of(c.condition, [](const Condition& condition) {
                   return (condition.light & sets::shadowed) != 0;
               });
    });
}

} // namespace

std::vector<std::uint32_t> run_assembled(const Case& kernel, std::span<const TexelPoint> points,
                                         const RunKernel& run) {
    Records records(kernel);
    for (const TexelPoint& point : points) {
        const std::array words{std::bit_cast<std::uint32_t>(point.texel.x),
                               std::bit_cast<std::uint32_t>(point.texel.y), bits(point.p.x), bits(point.p.y)};
        records.add(std::span(words).first(word_count(kernel)), point.mask);
    }
    return run(kernel, records);
}

Composition::Composition(std::span<const TexelPoint> points, RunKernel run_kernel)
    : points_(points.begin(), points.end()), all_(points.size()), run_(std::move(run_kernel)) {
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    for (const TexelPoint& point : points_) {
        facts_["texel"].push_back(std::bit_cast<std::uint32_t>(point.texel.x));
        facts_["texel"].push_back(std::bit_cast<std::uint32_t>(point.texel.y));
        for (const char* name : {"p", "p_x"}) facts_[name].push_back(bits(point.p.x));
        for (const char* name : {"p", "p_y"}) facts_[name].push_back(bits(point.p.y));
        facts_["entering"].push_back(point.mask->lit(point.texel.x, point.texel.y) ? 1 : 0);
        facts_["options"].push_back(0);
    }
    facts_["sides"] = run("revectorize/discontinuity");
    facts_["side_x"] = component("sides", 2, 0, 1);
    facts_["side_y"] = component("sides", 2, 1, 1);
    facts_["reach"] = run("revectorize/traversal");
    facts_["reach_x"] = component("reach", 4, 0, 2);
    facts_["reach_y"] = component("reach", 4, 2, 2);
    facts_["type_x"] = run("revectorize/edge_type", {{"reach", "reach_x"}});
    facts_["type_y"] = run("revectorize/edge_type", {{"reach", "reach_y"}});
    facts_["type"] = interleaved(facts_["type_x"], facts_["type_y"]);
    along_x_ = run("revectorize/along", {{"reach", "reach_x"}, {"c", "p_x"}});
    along_y_ = run("revectorize/along", {{"reach", "reach_y"}, {"c", "p_y"}});
    facts_["dominant"] = run("revectorize/dominance");
    set_walls();
}

Composition::Words Composition::run(const Case& kernel, std::span<const std::size_t> which,
                                    const std::map<std::string, std::string>& renamed) const {
    if (which.empty()) return {};
    struct Column {
        const Words* from;
        std::size_t components;
    };
    std::vector<Column> columns;
    for (std::size_t p = 0; p < kernel.parameters.size(); ++p) {
        const auto found = renamed.find(kernel.parameters[p].name);
        const std::string& name = found == renamed.end() ? kernel.parameters[p].name : found->second;
        columns.push_back(
            {&facts_.at(name), static_cast<std::size_t>(kernel.reference.parameters[p].components)});
    }
    Records records(kernel);
    Words words;
    for (const std::size_t i : which) {
        words.clear();
        for (const Column& column : columns)
            for (std::size_t k = 0; k < column.components; ++k)
                words.push_back((*column.from)[i * column.components + k]);
        records.add(words, points_[i].mask);
    }
    return run_(kernel, records);
}

Composition::Words Composition::run(const char* kernel,
                                    const std::map<std::string, std::string>& renamed) const {
    return run(find_case(kernel), all_, renamed);
}

Composition::Words Composition::component(const std::string& fact, std::size_t stride, std::size_t first,
                                          std::size_t count) const {
    const Words& words = facts_.at(fact);
    Words chosen;
    for (std::size_t i = first; i < words.size(); i += stride)
        for (std::size_t k = 0; k < count; ++k) chosen.push_back(words[i + k]);
    return chosen;
}

Composition::Words Composition::interleaved(const Words& x, const Words& y) const {
    Words both;
    for (std::size_t i = 0; i < x.size(); ++i) both.insert(both.end(), {x[i], y[i]});
    return both;
}

void Composition::set_positions(const Family& family) {
    facts_["along_x"] = along_x_;
    facts_["along_y"] = along_y_;
    if (family.name == "smsr") return; // nobody reads the others
    const bool filters = family.name == "rsmss";
    for (const std::string axis : {"x", "y"}) {
        const Words closed =
            filters ? run("revectorize/along_closed", {{"reach", "reach_" + axis}, {"c", "p_" + axis}})
                    : Words(points_.size(), bits(1));
        const Words& types = facts_["type_" + axis];
        Words& along = facts_["along_" + axis];
        for (std::size_t i = 0; i < along.size(); ++i) {
            const auto type = std::bit_cast<std::int32_t>(types[i]);
            if (type == 1)
                along[i] = closed[i];
            else if (type != 0 && !filters) // docs/decisions.md, B9
                along[i] = bits(1);
        }
    }
}

void Composition::set_walls() {
    std::vector<std::size_t> slots;
    for (const std::size_t i : all_)
        if (facts_["side_x"][i] == reference::both || facts_["side_y"][i] == reference::both)
            slots.push_back(i);
    const Words neighbours = run(find_case("revectorize/neighbours"), slots),
                breaches = run(find_case("revectorize/breach"), slots);
    Words& all_neighbours = facts_["neighbours"] = Words(2 * points_.size(), 0);
    Words& neighbour = facts_["neighbour"] = Words(points_.size(), 0);
    Words& breach = facts_["breach"] = Words(points_.size(), reference::unbroken);
    for (std::size_t n = 0; n < slots.size(); ++n) {
        const std::size_t i = slots[n];
        all_neighbours[2 * i] = neighbours[2 * n];
        all_neighbours[2 * i + 1] = neighbours[2 * n + 1];
        const std::uint32_t closed =
            facts_["side_x"][i] == reference::both ? facts_["side_y"][i] : facts_["side_x"][i];
        neighbour[i] = closed == reference::plus ? neighbours[2 * n] : neighbours[2 * n + 1];
        breach[i] = breaches[n];
    }
}

Composition::Composed Composition::compose(const Family& family) {
    set_positions(family);
    const Words& lit = facts_.at("entering");
    Composed composed;
    composed.numbers = run(*find_kernel(family, "decision"), all_);
    if (!looks_at_shadow(family))
        for (std::size_t i = 0; i < lit.size(); ++i)
            if (lit[i] == 0) composed.numbers[i] = 0;
    for (const std::uint32_t is_lit : lit) composed.visibility.push_back(bits(is_lit != 0 ? 1.0f : 0.0f));
    std::map<std::uint32_t, std::vector<std::size_t>> texels_of;
    for (const std::size_t i : all_) texels_of[composed.numbers[i]].push_back(i);
    for (const Case& c : family.cases) {
        const auto texels = texels_of.find(c.number);
        if (c.number == 0 || texels == texels_of.end()) continue;
        const Words values = run(c, texels->second);
        for (std::size_t n = 0; n < values.size(); ++n) composed.visibility[texels->second[n]] = values[n];
    }
    return composed;
}

} // namespace gnomon
