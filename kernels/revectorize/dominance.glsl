// At a corner (one side on each axis), which of its two edges go on beyond it: the neighbour away from the y side still
// has an x side (D_r), the neighbour away from the x side still has a y side (D_g).   [docs/revectorization.md 1.4; RBSM supplement, 1]
// Anywhere else there is nothing to choose between: neither.
#include "revectorize/discontinuity.glsl"

bvec2 revectorize_dominance(ivec2 texel, uvec2 sides) {
    bool corner = (sides.x == MINUS || sides.x == PLUS) && (sides.y == MINUS || sides.y == PLUS);
    if (!corner) return bvec2(false);
    ivec2 away = ivec2(sides.x == MINUS ? 1 : -1, sides.y == MINUS ? 1 : -1);
    return bvec2(revectorize_discontinuity(texel + ivec2(0, away.y)).x != NEITHER,
                 revectorize_discontinuity(texel + ivec2(away.x, 0)).y != NEITHER);
}
