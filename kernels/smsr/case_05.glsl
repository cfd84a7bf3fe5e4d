// An inner corner where only the edge on the y side goes on: that edge alone is straightened.   [SMSR case 5]
#include "revectorize/sides.glslh"
#include "smsr/case_09.glsl"
#include "smsr/case_10.glsl"

float smsr_case_05(vec2 p, float along_x, uint side_y) {
    return side_y == PLUS ? smsr_case_09(p, along_x) : smsr_case_10(p, along_x);
}
