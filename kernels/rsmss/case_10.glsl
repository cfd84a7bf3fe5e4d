// The closed end of a lit slot along x that opens further on: case 8 with x and y exchanged.   [RSMSS case 10]
#include "revectorize/sides.glslh"

float rsmss_case_10(vec2 p, float along_x, uint side_x, uint breach) {
    precise float from_end = side_x == PLUS ? 1.0 - p.x : p.x;
    precise float value = 1.0 - along_x;
    if (breach == MINUS) value = min(from_end, 1.0 + p.y - along_x);
    if (breach == PLUS) value = min(from_end, 2.0 - p.y - along_x);
    return clamp(value, 0.0, 1.0);
}
