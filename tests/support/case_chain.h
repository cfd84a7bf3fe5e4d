// A family's cases in double precision as its parts compose: edge, condition, case. What the assembled kernel
// is made of, without a device.
#pragma once

#include "casegen/catalogue.h"

#include <string>
#include <vector>

namespace gnomon::testing {

class CaseChain {
public:
    /// The numbered cases of the family of this name.
    explicit CaseChain(const std::string& family);

    /// The one case of an edge; null if none applies. Fails the test if several do.
    const Case* case_of(const reference::Edge& edge) const;

    /// The case's reference at `p`; the shadow test if no case applies. `options` goes to the parameter of
    /// that name.
    double value(const Mask& mask, glm::ivec2 texel, const reference::Edge& edge, glm::dvec2 p,
                 unsigned options = 0) const;

private:
    struct Known {
        const Case* kernel;
        std::vector<Fact> facts;    ///< by parameter; null for `options`
        std::vector<bool> is_along; ///< by parameter
    };
    std::vector<Known> cases_;
};

} // namespace gnomon::testing
