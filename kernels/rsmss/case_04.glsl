// A lit slot along y, one texel wide, with shadow at both of its ends. Where the slot loses a wall next to this texel, the
// texel is cut along the diagonal between that opening and the wall that goes on; amid more slot it is dark.
// [RSMSS case 4; docs/decisions.md, A4, C1, C2]
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_04(vec2 p, uvec2 neighbours, uint options) {
    bool opens_above = neighbours.y == MINUS || neighbours.y == PLUS; // towards +y
    bool opens_below = neighbours.x == MINUS || neighbours.x == PLUS;
    precise float above = neighbours.y == MINUS ? p.x + p.y - 1.0 : p.y - p.x;
    precise float below = neighbours.x == MINUS ? p.x - p.y : 1.0 - p.x - p.y;
    precise float value = 0.0;
    if (opens_below) value = below;
    if (opens_above) value = opens_below && (options & FIRST_OPENING) == 0u ? max(above, below) : above;
    return clamp(value, 0.0, 1.0);
}
