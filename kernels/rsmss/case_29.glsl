// A shadowed tooth, lit on an x side and at both ends along y: the ramp lies across it.   [RSMSS case 29]
#include "revectorize/sides.glslh"

float rsmss_case_29(vec2 p, uint side_x) {
    precise float light = side_x == MINUS ? 1.0 - p.x : p.x;
    return clamp(light, 0.0, 1.0);
}
