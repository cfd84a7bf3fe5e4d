// At a corner (one side on each axis), which of its two edges go on beyond it: the neighbour away from the y side still
// has an x side (D_r), the neighbour away from the x side still has a y side (D_g).   [docs/revectorization.md 1.4; RBSM supplement, 1]
// Anywhere else there is nothing to choose between: neither.
#include "revectorize/lit.glslh"
#include "revectorize/sides.glslh"

bvec2 revectorize_dominance(ivec2 texel, uvec2 sides) {
    bool corner = (sides.x == MINUS || sides.x == PLUS) && (sides.y == MINUS || sides.y == PLUS);
    if (!corner) return bvec2(false);
    ivec2 beyond_y = texel + ivec2(0, sides.y == MINUS ? 1 : -1);
    ivec2 beyond_x = texel + ivec2(sides.x == MINUS ? 1 : -1, 0);
    bool y_test = lit(beyond_y), x_test = lit(beyond_x);
    return bvec2(lit(beyond_y - ivec2(1, 0)) != y_test || lit(beyond_y + ivec2(1, 0)) != y_test,
                 lit(beyond_x - ivec2(0, 1)) != x_test || lit(beyond_x + ivec2(0, 1)) != x_test);
}
