// A shadowed texel with light on a y side: the part in the shadow of the ramp that case 22 begins.   [RSMSS case 30]
#include "revectorize/sides.glslh"

float rsmss_case_30(vec2 p, float along_x, uint side_y) {
    precise float light = side_y == PLUS ? p.y + along_x - 1.0 : along_x - p.y;
    return clamp(light, 0.0, 1.0);
}
