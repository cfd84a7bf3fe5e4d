// An inner corner where only the edge on the x side goes on: that edge alone is straightened.   [SMSR case 4]
#include "revectorize/sides.glslh"
#include "smsr/case_11.glsl"
#include "smsr/case_12.glsl"

float smsr_case_04(vec2 p, float along_y, uint side_x) {
    return side_x == MINUS ? smsr_case_11(p, along_y) : smsr_case_12(p, along_y);
}
