// A lit inner corner where both edges go on: the darker of the two ramps.   [RSMSS case 19]
#include "rsmss/case_16.glsl"
#include "rsmss/case_17.glsl"

float rsmss_case_19(vec2 p, float along_x, float along_y, uint side_x, uint side_y, int type_x, int type_y) {
    return min(rsmss_case_17(p, along_x, side_y, type_x), rsmss_case_16(p, along_y, side_x, type_y));
}
