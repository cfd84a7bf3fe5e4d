// Which of the four shapes a lit texel's edge has: 1 I, 2 U, 3 L, 4 O; 0 if nothing around it differs.
// [Optimized RBSM 2017, listing 4 and figure 2]
#include "revectorize/sides.glslh"

uint rbsm_silhouette_decision(uvec2 sides, ivec2 type) {
    if (sides == uvec2(NEITHER)) return 0u;
    bvec2 closed = bvec2(sides.x == BOTH || type.x == 1, sides.y == BOTH || type.y == 1);
    if (all(closed)) return 4u;
    if (any(closed)) return 2u;
    return type.x == -1 || type.y == -1 ? 1u : 3u;
}
