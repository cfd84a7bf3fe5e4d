// A shadowed tooth, lit on a y side and at both ends along x: the ramp lies across it.   [RSMSS case 28]
#include "revectorize/sides.glslh"

float rsmss_case_28(vec2 p, uint side_y) {
    precise float light = side_y == PLUS ? p.y : 1.0 - p.y;
    return clamp(light, 0.0, 1.0);
}
