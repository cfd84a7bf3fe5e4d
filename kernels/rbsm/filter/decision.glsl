// Which of the five shapes a texel's edge has: 1 I, 2 U, 3 L, 4 short O, 5 long O; 0 if nothing around it differs.
// U comes before I, so that a corridor open at both ends counts as a U.   [Optimized RBSM 2017, listing 5]
#include "revectorize/sides.glslh"

uint rbsm_filter_decision(uvec2 sides, ivec2 type) {
    if (sides == uvec2(NEITHER)) return 0u;
    if (sides == uvec2(BOTH)) return 4u;
    bvec2 closed = equal(type, ivec2(1));
    if (all(closed)) return 5u;
    if (any(closed)) return 2u;
    return type.x == -1 || type.y == -1 ? 1u : 3u;
}
