// A lit inner corner where only the edge on the x side goes on: that edge alone is ramped.   [RSMSS case 16]
#include "rsmss/case_21.glsl"
#include "rsmss/case_23.glsl"

float rsmss_case_16(vec2 p, float along_y, uint side_x, int type_y) {
    return type_y == 1 ? rsmss_case_21(p, side_x) : rsmss_case_23(p, along_y, side_x);
}
