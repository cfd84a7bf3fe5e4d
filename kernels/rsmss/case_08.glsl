// The closed end of a lit slot along y that opens further on: the ramp of the wall that goes on beyond the breach, or along
// the slot if none does, and never lighter than the distance from the closed end.   [RSMSS case 8]
#include "revectorize/sides.glslh"

float rsmss_case_08(vec2 p, float along_y, uint side_y, uint breach) {
    precise float from_end = side_y == PLUS ? 1.0 - p.y : p.y;
    precise float value = 1.0 - along_y;
    if (breach == MINUS) value = min(from_end, 1.0 + p.x - along_y);
    if (breach == PLUS) value = min(from_end, 2.0 - p.x - along_y);
    return clamp(value, 0.0, 1.0);
}
