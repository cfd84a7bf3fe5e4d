#include "tests/support/smsr_chain.h"

#include "tests/support/case_chain.h"

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

namespace {

const CaseChain& chain() {
    static const CaseChain cases("smsr");
    return cases;
}

} // namespace

const Case* smsr_case_of(const reference::Edge& edge) { return chain().case_of(edge); }

double smsr_by_cases(const reference::Edge& edge, glm::dvec2 p) {
    return chain().value(Mask(), {}, edge, p); // no case looks beyond the edge
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
