// A shadowed outer corner where only the edge on the x side goes on: that edge alone is ramped.   [RSMSS case 24]
#include "rsmss/case_29.glsl"
#include "rsmss/case_31.glsl"

float rsmss_case_24(vec2 p, float along_y, uint side_x, int type_y) {
    return type_y == 1 ? rsmss_case_29(p, side_x) : rsmss_case_31(p, along_y, side_x);
}
