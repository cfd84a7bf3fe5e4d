// Within a shadow bar along x: case 13 with x and y exchanged.   [RSMSS case 15; docs/decisions.md, A5, A6]
#include "revectorize/breach.glslh"
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_15(vec2 p, float along_x, int type_x, uint breach, uint options) {
    precise float minus = type_x == 1 ? 1.0 - p.y : along_x - p.y; // by the wall at -y, at +y
    precise float plus = type_x == 1 ? p.y : along_x + p.y - 1.0;
    precise float value = along_x;
    if (breach == MINUS) value = minus;
    if (breach == PLUS) value = plus;
    if (breach == BOTH) {
        value = min(minus, plus);
        if ((options & OPPOSITE_BREACH) != 0u) value = max(minus, plus);
        if ((options & FIRST_BREACH) != 0u) value = minus;
    }
    if (breach == UNBROKEN && type_x == 1) value = (options & RAMPED_BAR) != 0u ? max(p.y, 1.0 - p.y) : 0.0;
    return clamp(value, 0.0, 1.0);
}
