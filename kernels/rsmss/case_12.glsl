// The end of a shadow bar along y. Its light comes from the end itself and from the side where a wall of light goes on: by
// the position along the run if that begins at the next texel, over the whole texel's width if further on.
// A bar without breach stays dark.   [RSMSS case 12; docs/decisions.md, A6, A8]
#include "revectorize/breach.glslh"
#include "revectorize/sides.glslh"
#include "rsmss/options.glslh"

float rsmss_case_12(vec2 p, float along_y, uint side_y, int type_y, uint neighbour, uint breach, uint options) {
    precise float into_end = side_y == PLUS ? p.y : 1.0 - p.y;
    precise float minus = type_y == 1 ? 1.0 - p.x : along_y - p.x; // by the wall at -x, at +x
    precise float plus = type_y == 1 ? p.x : along_y + p.x - 1.0;
    if (neighbour == BOTH && (options & BREACH_BY_POSITION) == 0u) minus = 1.0 - p.x, plus = p.x;
    uint walls = neighbour == BOTH ? breach : neighbour;
    precise float value = along_y;
    if (walls == MINUS) value = max(into_end, minus);
    if (walls == PLUS) value = max(into_end, plus);
    if (walls == UNBROKEN && type_y == 1)
        value = (options & RAMPED_BAR) != 0u ? max(into_end, max(p.x, 1.0 - p.x)) : 0.0;
    return clamp(value, 0.0, 1.0);
}
