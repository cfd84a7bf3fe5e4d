// The end of a shadow bar along x: case 12 with x and y exchanged.   [RSMSS case 14; docs/decisions.md, A6, A8, C3, C4]
#include "revectorize/breach.glslh"
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_14(vec2 p, float along_x, uint side_x, int type_x, uint neighbour, uint breach, uint options) {
    precise float into_end = side_x == PLUS ? p.x : 1.0 - p.x;
    precise float minus = type_x == 1 ? 1.0 - p.y : along_x - p.y; // by the wall at -y, at +y
    precise float plus = type_x == 1 ? p.y : along_x + p.y - 1.0;
    if (neighbour == BOTH && (options & BREACH_BY_POSITION) == 0u) minus = 1.0 - p.y, plus = p.y;
    uint walls = neighbour == BOTH ? breach : neighbour;
    precise float value = along_x;
    if (walls == MINUS) value = max(into_end, minus);
    if (walls == PLUS) value = max(into_end, plus);
    if (walls == UNBROKEN && type_x == 1)
        value = (options & RAMPED_BAR) != 0u ? max(into_end, max(p.y, 1.0 - p.y)) : 0.0;
    return clamp(value, 0.0, 1.0);
}
