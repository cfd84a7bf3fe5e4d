#include "tests/support/case_chain.h"

#include <gtest/gtest.h>

namespace gnomon::testing {

CaseChain::CaseChain(const std::string& family) {
    for (const Family& f : catalogue())
        if (f.name == family)
            for (const Case& c : f.cases) {
                if (c.number == 0) continue;
                Known known{&c, {}, {}};
                for (const Parameter& parameter : c.parameters) {
                    known.facts.push_back(find_fact(parameter.name));
                    known.is_along.push_back(parameter.name.starts_with("along"));
                }
                cases_.push_back(std::move(known));
            }
    EXPECT_FALSE(cases_.empty()) << family;
}

const Case* CaseChain::case_of(const reference::Edge& edge) const {
    const Case* found = nullptr;
    for (const Known& known : cases_) {
        if (!holds(known.kernel->condition, edge)) continue;
        EXPECT_EQ(found, nullptr) << found->name << " and " << known.kernel->name << " apply to one edge";
        found = known.kernel;
    }
    return found;
}

double CaseChain::value(const Mask& mask, glm::ivec2 texel, const reference::Edge& edge, glm::dvec2 p,
                        unsigned options) const {
    for (const Known& known : cases_) {
        if (!holds(known.kernel->condition, edge)) continue;
        Facts facts;
        facts.texel = texel;
        facts.p = p;
        facts.edge = edge;
        facts.mask = &mask;
        Arguments arguments;
        std::size_t word = 0;
        for (std::size_t i = 0; i < known.facts.size(); ++i) {
            Numbers numbers{};
            int components = 1;
            if (!known.facts[i])
                numbers[0] = options;
            else
                components = known.facts[i](facts, numbers);
            if (components == 0 && known.is_along[i]) { // no position along a run that ends nowhere, or twice
                const bool y = known.kernel->parameters[i].name == "along_y";
                const glm::ivec2 reach =
                    y ? glm::ivec2(edge.reach.z, edge.reach.w) : glm::ivec2(edge.reach.x, edge.reach.y);
                numbers[0] =
                    reference::edge_type(reach) == 1 ? reference::along_closed(reach, y ? p.y : p.x) : 1;
                components = 1;
            } else if (known.is_along[i] && (options & 32u) != 0) { // docs/decisions.md, A7
                const bool y = known.kernel->parameters[i].name == "along_y";
                numbers[0] = y ? reference::along_unclamped({edge.reach.z, edge.reach.w}, p.y)
                               : reference::along_unclamped({edge.reach.x, edge.reach.y}, p.x);
            }
            EXPECT_EQ(components, known.kernel->reference.parameters[i].components) << known.kernel->name;
            for (int k = 0; k < components; ++k)
                arguments.numbers[word++] = numbers[static_cast<std::size_t>(k)];
        }
        return known.kernel->reference.call(arguments)[0];
    }
    return edge.lit ? 1 : 0;
}

} // namespace gnomon::testing
