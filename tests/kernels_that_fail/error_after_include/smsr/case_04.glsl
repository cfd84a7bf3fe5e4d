// The name on line 7 is unknown.
#include "revectorize/sides.glslh"
#include "smsr/case_11.glsl"
#include "smsr/case_12.glsl"

float smsr_case_04(vec2 p, float along_y, uint side_x) {
    return side_x == MINUS ? smsr_case_11(p, along_y) : smsr_case_13(p, along_y);
}
