// A lit slot along x, one texel wide, with shadow at both of its ends: case 4 with x and y exchanged.
// [RSMSS case 6; docs/decisions.md, A4]
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_06(vec2 p, uvec2 neighbours, uint options) {
    bool opens_right = neighbours.y == MINUS || neighbours.y == PLUS; // towards +x
    bool opens_left = neighbours.x == MINUS || neighbours.x == PLUS;
    precise float right = neighbours.y == MINUS ? p.x + p.y - 1.0 : p.x - p.y;
    precise float left = neighbours.x == MINUS ? p.y - p.x : 1.0 - p.x - p.y;
    precise float value = 0.0;
    if (opens_left) value = left;
    if (opens_right) value = opens_left && (options & FIRST_OPENING) == 0u ? max(right, left) : right;
    return clamp(value, 0.0, 1.0);
}
