// A shadowed outer corner of a lone step: the ramp runs across the texel's diagonal.   [RSMSS case 26]
#include "revectorize/sides.glslh"

float rsmss_case_26(vec2 p, float along_x, uint side_y) {
    precise float light = side_y == PLUS ? along_x + p.y - 1.0 : along_x - p.y;
    return clamp(light, 0.0, 1.0);
}
