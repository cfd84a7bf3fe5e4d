// The end of a lit slot along y that is closed on its y side, with shadow at the far end too. If the next texel has lost a
// wall, this one is cut along the diagonal between that opening and the wall that goes on; else it is dark.
// [RSMSS case 5; docs/decisions.md, A3, C2, C11]
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_05(vec2 p, float along_y, uint side_y, uint neighbour, uint options) {
    precise float value = 0.0;
    if (neighbour == MINUS) value = side_y == MINUS ? p.x + p.y - 1.0 : p.x - p.y;
    if (neighbour == PLUS) value = side_y == MINUS ? p.y - p.x : 1.0 - p.x - p.y;
    if (neighbour == BOTH && (options & PRINTED_END) != 0u) {
        precise float from_end = side_y == PLUS ? 1.0 - p.y : p.y;
        value = min(min(p.x - along_y + 1.0, 2.0 - along_y - p.x), from_end);
    }
    return clamp(value, 0.0, 1.0);
}
