// The end of a lit slot along x that is closed on its x side: case 5 with x and y exchanged.
// [RSMSS case 7; docs/decisions.md, A3, C10]
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_07(vec2 p, float along_x, uint side_x, uint neighbour, uint options) {
    precise float value = 0.0;
    if (neighbour == MINUS) value = side_x == MINUS ? p.x + p.y - 1.0 : p.y - p.x;
    if (neighbour == PLUS) value = side_x == MINUS ? p.x - p.y : 1.0 - p.x - p.y;
    if (neighbour == BOTH && (options & PRINTED_END) != 0u) {
        precise float from_end = side_x == PLUS ? 1.0 - p.x : p.x;
        value = min(min(p.y - along_x + 1.0, 2.0 - along_x - p.y), from_end);
    }
    return clamp(value, 0.0, 1.0);
}
