// A shadowed texel with light on an x side: case 30 with x and y exchanged.   [RSMSS case 31]
#include "revectorize/sides.glslh"

float rsmss_case_31(vec2 p, float along_y, uint side_x) {
    precise float light = side_x == MINUS ? along_y - p.x : p.x + along_y - 1.0;
    return clamp(light, 0.0, 1.0);
}
