// The end of a lit slot along x that is closed on its x side: case 5 with x and y exchanged.
// [RSMSS case 7; docs/decisions.md, A3, C10]
#include "rsmss/case_05.glsl"

float rsmss_case_07(vec2 p, float along_x, uint side_x, uint neighbour, uint options) {
    return rsmss_case_05(vec2(p.y, p.x), along_x, side_x, neighbour, options);
}
