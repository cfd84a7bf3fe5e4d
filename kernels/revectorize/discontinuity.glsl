// On which sides, along x and along y, the neighbour's shadow test differs from the texel's own: d_c.   [Optimized RBSM 2017, listing 2]
#include "revectorize/lit.glslh"
#include "revectorize/sides.glslh"

uvec2 revectorize_discontinuity(ivec2 texel) {
    bool here = lit(texel);
    uvec2 sides = uvec2(NEITHER);
    if (lit(texel - ivec2(1, 0)) != here) sides.x |= MINUS;
    if (lit(texel + ivec2(1, 0)) != here) sides.x |= PLUS;
    if (lit(texel - ivec2(0, 1)) != here) sides.y |= MINUS;
    if (lit(texel + ivec2(0, 1)) != here) sides.y |= PLUS;
    return sides;
}
