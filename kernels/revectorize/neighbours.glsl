// Of a texel with a side on BOTH along one axis (a slot in shadow, a bar in light): which sides, on that axis, the texels
// next along it have, towards - and towards +: n(d_c).   [RBSM supplement, 3; docs/revectorization.md 1.5]
// Only texels with this one's own shadow test count; what a texel beyond a closed end has, nobody asks.
#include "revectorize/walls.glslh"

uvec2 revectorize_neighbours(ivec2 texel, uvec2 sides) {
    ivec2 along = sides.x == BOTH ? ivec2(0, 1) : ivec2(1, 0);
    return uvec2(walls_of(texel - along, along.yx, lit(texel - along)), walls_of(texel + along, along.yx, lit(texel + along)));
}
