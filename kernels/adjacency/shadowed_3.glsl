// All three neighbours face away: every edge stays, every corner is cut. Four triangles.   [thesis 4.4, figure 32, equation 23]
#include "adjacency/polygon.glslh"

vec2 adjacency_shadowed_3(vec2 v0, vec2 v2, vec2 v4, float lambda, uint corner) {
    return adjacency_vertex(adjacency_polygon(v0, v2, v4, lambda, 7u, 7u), v0, v2, v4, corner);
}
