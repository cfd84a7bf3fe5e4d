// Within a shadow bar along x: case 13 with x and y exchanged.   [RSMSS case 15; docs/decisions.md, A5, A6]
#include "rsmss/case_13.glsl"

float rsmss_case_15(vec2 p, float along_x, int type_x, uint breach, uint options) {
    return rsmss_case_13(vec2(p.y, p.x), along_x, type_x, breach, options);
}
