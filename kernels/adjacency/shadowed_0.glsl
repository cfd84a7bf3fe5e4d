// No neighbour faces away: every edge of v0 v2 v4 moves in by lambda, one triangle.   [thesis 4.1, figure 27]
#include "adjacency/polygon.glslh"

vec2 adjacency_shadowed_0(vec2 v0, vec2 v2, vec2 v4, float lambda, uint corner) {
    return adjacency_vertex(adjacency_polygon(v0, v2, v4, lambda, 0u, 0u), v0, v2, v4, corner);
}
