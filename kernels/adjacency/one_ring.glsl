// The same, knowing of each vertex whether all faces around it face away (`inner`, bit 0: v0, 1: v2, 2: v4): a corner between two
// edges that stay is cut only where one of them does not. This closes the holes at inner vertices.   [thesis 4.5; docs/decisions.md H11]
#include "adjacency/polygon.glslh"

vec2 adjacency_one_ring(vec2 v0, vec2 v2, vec2 v4, float lambda, uint away, uint inner, uint corner) {
    return adjacency_vertex(adjacency_polygon(v0, v2, v4, lambda, away, adjacency_between(away) & ~inner), v0, v2, v4, corner);
}
