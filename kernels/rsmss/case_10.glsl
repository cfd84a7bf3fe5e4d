// The closed end of a lit slot along x that opens further on: case 8 with x and y exchanged.   [RSMSS case 10]
#include "rsmss/case_08.glsl"

float rsmss_case_10(vec2 p, float along_x, uint side_x, uint breach) {
    return rsmss_case_08(vec2(p.y, p.x), along_x, side_x, breach);
}
