// The end of a shadow bar along x: case 12 with x and y exchanged.   [RSMSS case 14; docs/decisions.md, A6, A8, C3, C4]
#include "rsmss/case_12.glsl"

float rsmss_case_14(vec2 p, float along_x, uint side_x, int type_x, uint neighbour, uint breach, uint options) {
    return rsmss_case_12(vec2(p.y, p.x), along_x, side_x, type_x, neighbour, breach, options);
}
