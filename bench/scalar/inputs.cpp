#include "bench/scalar/scalar.h"

#include "casegen/census.h"
#include "casegen/sampling.h"

#include <algorithm>

namespace gnomon::scalar {

unsigned number_of(const Family& family, const reference::Edge& edge) {
    for (const Case* c : numbered_cases(family))
        if (holds(c->condition, edge)) return c->number;
    return 0;
}

Input make_input(const Family& family, const Facts& facts) {
    Input input{number_of(family, facts.edge), facts.edge, {}};
    for (const CaseParameter& p : case_parameters(family, {})) {
        const Fact fact = find_fact(p.name);
        Numbers numbers{};
        if (fact) fact(facts, numbers);
        const bool has_two = p.type.ends_with('2');
        input.values.insert(input.values.end(), numbers.begin(), numbers.begin() + (has_two ? 2 : 1));
    }
    return input;
}

std::vector<unsigned> corpus_order(const Family& family) {
    Counts counts(256);
    for (const EdgePool::Entry& entry : make_edge_pool(1).entries) ++counts[number_of(family, entry.edge())];
    Assembly order{.cases = cases_by_frequency(family, counts)};
    for (const Case* c : left_out_cases(family, order)) order.cases.push_back(c->number);
    return order.cases;
}

} // namespace gnomon::scalar
