// How far an edge with this unit normal must move for a texel of this width and height, centred on it, to lie on one side: the
// half extent of the texel along the normal. Never more than half the texel's diagonal, which is enough for every
// direction.   [Hasselgren et al. 2005]
#include "conservative/lines.glslh"

float conservative_tight_offset(vec2 normal, vec2 texel) {
    precise float offset = 0.5 * abs(normal.x) * abs(texel.x) + 0.5 * abs(normal.y) * abs(texel.y);
    return bounded(offset);
}
