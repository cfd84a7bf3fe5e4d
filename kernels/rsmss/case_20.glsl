// A lit notch, shadowed on a y side and at both ends along x: the ramp lies across it.   [RSMSS case 20]
#include "revectorize/sides.glslh"

float rsmss_case_20(vec2 p, uint side_y) {
    precise float light = side_y == PLUS ? 1.0 - p.y : p.y;
    return clamp(light, 0.0, 1.0);
}
