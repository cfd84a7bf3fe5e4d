// Within a lit slot along x: case 9 with x and y exchanged.   [RSMSS case 11; docs/decisions.md, A5, C6]
#include "rsmss/case_09.glsl"

float rsmss_case_11(vec2 p, float along_x, uint breach, uint options) {
    return rsmss_case_09(vec2(p.y, p.x), along_x, breach, options);
}
