// Of a texel with a side on BOTH along one axis (a slot in shadow, a bar in light): which sides, on that axis, the texels
// next along it have, towards - and towards +: n(d_c).   [RBSM supplement, 3; docs/revectorization.md 1.5]
// Only texels with this one's own shadow test count; what a texel beyond a closed end has, nobody asks.
#include "revectorize/discontinuity.glsl"

uvec2 revectorize_neighbours(ivec2 texel, uvec2 sides) {
    if (sides.x == BOTH)
        return uvec2(revectorize_discontinuity(texel - ivec2(0, 1)).x, revectorize_discontinuity(texel + ivec2(0, 1)).x);
    return uvec2(revectorize_discontinuity(texel - ivec2(1, 0)).y, revectorize_discontinuity(texel + ivec2(1, 0)).y);
}
