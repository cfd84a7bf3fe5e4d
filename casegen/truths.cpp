#include "casegen/truths.h"

namespace gnomon {

std::vector<Truth> truths(const Case& c, const Records& records) {
    if (!c.reference.truth) return {};
    std::vector<Truth> all(records.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Arguments with = arguments(c, records.input(i), records.mask(i));
        if (in_domain(c, with)) all[i] = c.reference.truth(with);
    }
    return all;
}

} // namespace gnomon
