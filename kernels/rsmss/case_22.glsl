// A lit texel with shadow on a y side: the part in the light of the ramp, one texel high, about the line from the middle of
// the run's end to the middle of the shadow at its beginning.   [RSMSS case 22]
#include "revectorize/sides.glslh"

float rsmss_case_22(vec2 p, float along_x, uint side_y) {
    precise float light = side_y == PLUS ? 2.0 - p.y - along_x : 1.0 + p.y - along_x;
    return clamp(light, 0.0, 1.0);
}
