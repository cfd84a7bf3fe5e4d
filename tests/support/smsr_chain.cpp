#include "tests/support/smsr_chain.h"

#include <gtest/gtest.h>

namespace gnomon::testing {

const std::vector<const Case*>& smsr_cases() {
    static const std::vector<const Case*> cases = [] {
        std::vector<const Case*> numbered;
        for (const Case* c : find_cases("smsr/*"))
            if (c->number != 0) numbered.push_back(c);
        return numbered;
    }();
    return cases;
}

const Case* smsr_case_of(const reference::Edge& edge) {
    const Case* found = nullptr;
    for (const Case* c : smsr_cases()) {
        if (!applies(*c, edge)) continue;
        EXPECT_EQ(found, nullptr) << found->name << " and " << c->name << " apply to one edge";
        found = c;
    }
    return found;
}

double smsr_by_cases(const reference::Edge& edge, glm::dvec2 p) {
    const Case* c = smsr_case_of(edge);
    if (!c) return 1;
    Facts facts;
    facts.p = p;
    facts.edge = edge;
    Arguments arguments;
    std::size_t word = 0;
    for (std::size_t i = 0; i < c->parameters.size(); ++i) {
        Numbers numbers{};
        const int components = find_fact(c->parameters[i].name)(facts, numbers);
        EXPECT_EQ(components, c->reference.parameters[i].components)
            << c->name << " needs " << c->parameters[i].name << ", which this edge does not have";
        std::copy_n(numbers.begin(), components,
                    arguments.numbers.begin() + static_cast<std::ptrdiff_t>(word));
        word += static_cast<std::size_t>(components);
    }
    return c->reference.call(arguments)[0];
}

const std::vector<double>& SmsrChain::values(const reference::Edge& edge) {
    std::vector<double>& values = known_[edge_key(edge)];
    if (values.empty())
        for (const glm::dvec2 p : points_) values.push_back(smsr_by_cases(edge, p));
    return values;
}

std::uint64_t decision_key(const reference::Edge& edge) {
    std::uint64_t key = edge.sides.x | edge.sides.y << 2;
    key = key << 4 | static_cast<std::uint64_t>((edge.type.x + 1) | (edge.type.y + 1) << 2);
    return key << 2 | (edge.dominant.x ? 1u : 0u) | (edge.dominant.y ? 2u : 0u);
}

std::uint64_t edge_key(const reference::Edge& edge) {
    std::uint64_t key = decision_key(edge);
    for (int i = 0; i < 4; ++i) key = key << 8 | static_cast<std::uint64_t>(edge.reach[i] + 32);
    return key;
}

} // namespace gnomon::testing
