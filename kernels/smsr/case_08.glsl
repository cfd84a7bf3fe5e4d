// An inner corner where both edges go on: dark where either of the two straightened edges is.   [SMSR case 8]
#include "smsr/case_04.glsl"
#include "smsr/case_05.glsl"

float smsr_case_08(vec2 p, float along_x, float along_y, uint side_x, uint side_y) {
    return min(smsr_case_05(p, along_x, side_y), smsr_case_04(p, along_y, side_x));
}
