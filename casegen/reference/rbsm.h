// The shapes that replace the cases of SMSR and RSMSS: Optimized RBSM 2017, listings 4 and 5, in double.
#pragma once

#include "casegen/reference/revectorize.h"

namespace gnomon::reference {

/// Listing 4, for lit texels: 0 or 1. Distances from the edge's end are normalised along both axes from the
/// same walks: along an axis without a run it is the distance to the side itself.
double rbsm_silhouette(const Edge& edge, glm::dvec2 p);

/// Listing 5 (its test for I corrected to -1), 0 to 1. `open_first` tests I before U: a corridor that is open
/// at both ends then keeps its shadow test.
double rbsm_filter(const Edge& edge, glm::dvec2 p, bool open_first = false);

} // namespace gnomon::reference
