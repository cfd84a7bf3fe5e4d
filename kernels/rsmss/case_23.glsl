// A lit texel with shadow on an x side: case 22 with x and y exchanged.   [RSMSS case 23]
#include "revectorize/sides.glslh"

float rsmss_case_23(vec2 p, float along_y, uint side_x) {
    precise float light = side_x == MINUS ? 1.0 + p.x - along_y : 2.0 - p.x - along_y;
    return clamp(light, 0.0, 1.0);
}
