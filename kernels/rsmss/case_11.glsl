// Within a lit slot along x: case 9 with x and y exchanged.   [RSMSS case 11; docs/decisions.md, A5, C6]
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_11(vec2 p, float along_x, uint breach, uint options) {
    precise float minus = 1.0 + p.y - along_x, plus = 2.0 - p.y - along_x; // by the wall at -y, at +y
    precise float value = 1.0 - along_x;
    if (breach == MINUS) value = minus;
    if (breach == PLUS) value = plus;
    if (breach == BOTH) {
        value = max(minus, plus);
        if ((options & OPPOSITE_BREACH) != 0u) value = min(minus, plus);
        if ((options & FIRST_BREACH) != 0u) value = minus;
    }
    return clamp(value, 0.0, 1.0);
}
