// One neighbour faces away: its edge stays, the two others move in by lambda, one triangle.   [thesis 4.2, figures 28, 29, equation 21]
#include "adjacency/polygon.glslh"

vec2 adjacency_shadowed_1(vec2 v0, vec2 v2, vec2 v4, float lambda, uint away, uint corner) {
    return adjacency_vertex(adjacency_polygon(v0, v2, v4, lambda, away, 0u), v0, v2, v4, corner);
}
