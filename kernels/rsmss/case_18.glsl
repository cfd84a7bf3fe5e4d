// A lit inner corner of a lone step: the ramp runs across the texel's diagonal.   [RSMSS case 18]
#include "revectorize/sides.glslh"

float rsmss_case_18(vec2 p, float along_x, uint side_y) {
    precise float light = side_y == PLUS ? 2.0 - along_x - p.y : 1.0 + p.y - along_x;
    return clamp(light, 0.0, 1.0);
}
