// A lit notch, shadowed on an x side and at both ends along y: the ramp lies across it.   [RSMSS case 21]
#include "revectorize/sides.glslh"

float rsmss_case_21(vec2 p, uint side_x) {
    precise float light = side_x == MINUS ? p.x : 1.0 - p.x;
    return clamp(light, 0.0, 1.0);
}
