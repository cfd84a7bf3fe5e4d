// Which of the 31 cases a texel is, 0 if it keeps its shadow test: no side, or a shadowed texel beside an edge without end.
// `entering`: the texel is lit.   [docs/revectorization.md 4.1]
// Corners come before single edges, and a run's type counts only along the axis that was walked, for across a BOTH both
// walks end at once.   [docs/decisions.md A1, C8, C9]
#include "revectorize/sides.glslh"

uint rsmss_decision(bool entering, uvec2 sides, ivec2 type, bvec2 dominant) {
    if (sides == uvec2(NEITHER)) return 0u;
    if (sides == uvec2(BOTH)) return entering ? 2u : 3u;
    if (sides.x == BOTH) {
        bool alone = sides.y == NEITHER;
        if (type.y == -1) return entering ? 1u : 0u;
        if (!entering) return alone ? 13u : 12u;
        if (type.y == 1) return alone ? 4u : 5u;
        return alone ? 9u : 8u;
    }
    if (sides.y == BOTH) {
        bool alone = sides.x == NEITHER;
        if (type.x == -1) return entering ? 1u : 0u;
        if (!entering) return alone ? 15u : 14u;
        if (type.x == 1) return alone ? 6u : 7u;
        return alone ? 11u : 10u;
    }
    if (sides.x != NEITHER && sides.y != NEITHER) {
        if (dominant.x && dominant.y) return entering ? 19u : 27u;
        if (dominant.x) return entering ? 16u : 24u;
        if (dominant.y) return entering ? 17u : 25u;
        return entering ? 18u : 26u;
    }
    if (sides.x == NEITHER) {
        if (type.x == -1) return entering ? 1u : 0u;
        if (type.x == 1) return entering ? 20u : 28u;
        return entering ? 22u : 30u;
    }
    if (type.y == -1) return entering ? 1u : 0u;
    if (type.y == 1) return entering ? 21u : 29u;
    return entering ? 23u : 31u;
}
