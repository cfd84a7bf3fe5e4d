// Which neighbours of v0 v2 v4 face the way that it does, by the sides on which they show their windings in the light's view: bit
// 0 (v0, v1, v2), bit 1 (v2, v3, v4), bit 2 (v4, v5, v0). Where all windings are consistent and v0 v2 v4 faces away from the light,
// these face away too. A missing neighbour, whose vertex repeats the one before, and one seen edge-on count as
// lit.   [thesis fig. 26 and eq. 20; docs/decisions.md H9]
#include "conservative/lines.glslh"

// 1 or -1 by its winding, 0 if it is seen edge-on.
int adjacency_winding(vec2 a, vec2 b, vec2 c) {
    if (conservative_is_sliver(a, b, c)) return 0;
    return conservative_cross(conservative_direction(b - a), conservative_direction(c - a)) < 0.0 ? -1 : 1;
}

uint adjacency_away(vec2 v0, vec2 v1, vec2 v2, vec2 v3, vec2 v4, vec2 v5) {
    int central = adjacency_winding(v0, v2, v4);
    if (central == 0) return 0u;
    return (adjacency_winding(v0, v1, v2) == central ? 1u : 0u) | (adjacency_winding(v2, v3, v4) == central ? 2u : 0u) |
           (adjacency_winding(v4, v5, v0) == central ? 4u : 0u);
}
