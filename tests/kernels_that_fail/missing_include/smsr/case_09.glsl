// Includes what is not there, on line 3.

#include "smsr/nowhere.glsl"
float smsr_case_09(vec2 p, float along_x) {
    return nowhere(p);
}
