// A lit inner corner where only the edge on the y side goes on: that edge alone is ramped.   [RSMSS case 17]
#include "rsmss/case_20.glsl"
#include "rsmss/case_22.glsl"

float rsmss_case_17(vec2 p, float along_x, uint side_y, int type_x) {
    return type_x == 1 ? rsmss_case_20(p, side_y) : rsmss_case_22(p, along_x, side_y);
}
