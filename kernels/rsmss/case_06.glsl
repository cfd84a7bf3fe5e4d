// A lit slot along x, one texel wide, with shadow at both of its ends: case 4 with x and y exchanged.
// [RSMSS case 6; docs/decisions.md, A4]
#include "rsmss/case_04.glsl"

float rsmss_case_06(vec2 p, uvec2 neighbours, uint options) {
    return rsmss_case_04(vec2(p.y, p.x), neighbours, options);
}
