// The compact silhouette function of "Optimized Visibility Functions for Revectorization-Based Shadow
// Mapping" (2017), listing 4: by the four shapes of an edge instead of twelve cases.
#pragma once

#include "casegen/reference/revectorize.h"

namespace gnomon::testing {

/// Distances from the edge's end, normalised along both axes from the same walks (an axis that is not run
/// along has walks of one texel: there it is the distance to the side itself).
inline double four_shape_visibility(const reference::Edge& edge, glm::dvec2 p) {
    using reference::both;
    if (edge.sides.x == both || edge.sides.y == both) return 0; // short U and O
    if (edge.type.x == 1 || edge.type.y == 1) return 0;         // long U and O
    if (edge.type.x == -1 || edge.type.y == -1) return 1;       // I
    const double x = 1 - reference::along({edge.reach.x, edge.reach.y}, p.x);
    const double y = 1 - reference::along({edge.reach.z, edge.reach.w}, p.y);
    return y < 1 - x ? 0 : 1; // L: step(1 - x, y)
}

} // namespace gnomon::testing
