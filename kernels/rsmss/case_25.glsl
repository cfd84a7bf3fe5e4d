// A shadowed outer corner where only the edge on the y side goes on: that edge alone is ramped.   [RSMSS case 25]
#include "rsmss/case_28.glsl"
#include "rsmss/case_30.glsl"

float rsmss_case_25(vec2 p, float along_x, uint side_y, int type_x) {
    return type_x == 1 ? rsmss_case_28(p, side_y) : rsmss_case_30(p, along_x, side_y);
}
