// A shadowed outer corner where both edges go on: the lighter of the two ramps.   [RSMSS case 27]
#include "rsmss/case_24.glsl"
#include "rsmss/case_25.glsl"

float rsmss_case_27(vec2 p, float along_x, float along_y, uint side_x, uint side_y, int type_x, int type_y) {
    return max(rsmss_case_25(p, along_x, side_y, type_x), rsmss_case_24(p, along_y, side_x, type_y));
}
