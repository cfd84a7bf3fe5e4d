// Which of the twelve cases a lit texel is, 0 if nothing around it differs.   [docs/revectorization.md 2.1]
// Open ends come first (case 1 before 2 and 3), so that an open corridor one texel wide stays lit; a run's type counts only
// along the axis that was walked, for across a BOTH both walks end at once.   [docs/decisions.md A1, A2]
#include "revectorize/sides.glslh"

uint smsr_decision(uvec2 sides, ivec2 type, bvec2 dominant) {
    if (sides == uvec2(NEITHER)) return 0u;
    if (sides.x == NEITHER) {
        if (type.x == -1) return 1u;
        if (type.x == 1) return 2u;
        if (sides.y == BOTH) return 3u;
        return sides.y == PLUS ? 9u : 10u;
    }
    if (sides.y == NEITHER) {
        if (type.y == -1) return 1u;
        if (type.y == 1) return 2u;
        if (sides.x == BOTH) return 3u;
        return sides.x == MINUS ? 11u : 12u;
    }
    if (sides.x == BOTH) return sides.y != BOTH && type.y == 1 ? 2u : 3u;
    if (sides.y == BOTH) return type.x == 1 ? 2u : 3u;
    if (type.x == 1 || type.y == 1) return 2u;
    if (dominant.x && dominant.y) return 8u;
    if (dominant.x) return 4u;
    if (dominant.y) return 5u;
    return sides.y == PLUS ? 6u : 7u;
}
