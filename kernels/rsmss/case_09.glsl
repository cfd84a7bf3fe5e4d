// Within a lit slot along y: the ramp of the wall that goes on beyond the nearest breach, or along the slot if none does.
// [RSMSS case 9; docs/decisions.md, A5]
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_09(vec2 p, float along_y, uint breach, uint options) {
    precise float minus = 1.0 + p.x - along_y, plus = 2.0 - p.x - along_y; // by the wall at -x, at +x
    precise float value = 1.0 - along_y;
    if (breach == MINUS) value = minus;
    if (breach == PLUS) value = plus;
    if (breach == BOTH) {
        value = max(minus, plus);
        if ((options & OPPOSITE_BREACH) != 0u) value = min(minus, plus);
        if ((options & FIRST_BREACH) != 0u) value = minus;
    }
    return clamp(value, 0.0, 1.0);
}
