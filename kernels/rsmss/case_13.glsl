// Within a shadow bar along y: the ramp of the wall of light that goes on beyond the nearest breach, or along the bar if none
// does. A bar without breach stays dark.   [RSMSS case 13; docs/decisions.md, A5, A6]
#include "revectorize/breach.glslh"
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_13(vec2 p, float along_y, int type_y, uint breach, uint options) {
    precise float minus = type_y == 1 ? 1.0 - p.x : along_y - p.x; // by the wall at -x, at +x
    precise float plus = type_y == 1 ? p.x : along_y + p.x - 1.0;
    precise float value = along_y;
    if (breach == MINUS) value = minus;
    if (breach == PLUS) value = plus;
    if (breach == BOTH) {
        value = min(minus, plus);
        if ((options & OPPOSITE_BREACH) != 0u) value = max(minus, plus);
        if ((options & FIRST_BREACH) != 0u) value = minus;
    }
    if (breach == UNBROKEN && type_y == 1) value = (options & RAMPED_BAR) != 0u ? max(p.x, 1.0 - p.x) : 0.0;
    return clamp(value, 0.0, 1.0);
}
