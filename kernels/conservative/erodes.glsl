// Whether something is left of the triangle when its edges move in by lambda: every new edge points the way of the old one, so
// the triangle has not turned inside out. Nothing is left of a triangle that is a line to within rounding.   [docs/decisions.md H12]
#include "conservative/eroded_edges.glslh"

bool conservative_erodes(vec2 a, vec2 b, vec2 c, float lambda) {
    return conservative_keep_direction(conservative_eroded_edges(a, b, c, lambda));
}
