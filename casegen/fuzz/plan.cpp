#include "casegen/fuzz/plan.h"

#include <algorithm>

namespace gnomon::fuzz {

Plan make_plan(std::span<const Case* const> cases, std::optional<std::uint64_t> samples) {
    Plan plan{{cases.begin(), cases.end()}, {}, {}};
    std::uint64_t whole = 0;
    for (const Case* c : cases) whole += unit_size(*c);
    for (const Case* c : cases) {
        std::size_t size = unit_size(*c);
        if (samples && *samples < whole) // one round of smaller units
            size = std::max<std::size_t>(1, (size * *samples + whole - 1) / whole);
        plan.sizes.push_back(size);
    }
    if (samples) plan.rounds = std::max<std::uint64_t>(1, (*samples + whole - 1) / whole);
    return plan;
}

} // namespace gnomon::fuzz
