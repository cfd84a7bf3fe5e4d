// What the four texels say together whose centres surround the point p of this one, the footprint of bilinear filtering: 0
// certainly shadowed, 1 certainly lit, 2 uncertain, to be traced. The tests are compared, not a filtered
// value.   [Beister et al. 2005; docs/hybrid.md]
#include "revectorize/lit.glslh"

uint certainty_bilinear(ivec2 texel, vec2 p) {
    ivec2 first = texel - ivec2(p.x < 0.5, p.y < 0.5);
    int votes = int(lit(first)) + int(lit(first + ivec2(1, 0))) + int(lit(first + ivec2(0, 1))) + int(lit(first + ivec2(1, 1)));
    return votes == 0 ? 0u : votes == 4 ? 1u : 2u;
}
