// Two neighbours face away: their edges stay, the third moves in by lambda, and the corner between the two is cut, for its vertex
// may belong to a lit triangle that no edge leads to. Two triangles.   [thesis 4.3, figures 30, 31, equation 22]
#include "adjacency/polygon.glslh"

vec2 adjacency_shadowed_2(vec2 v0, vec2 v2, vec2 v4, float lambda, uint away, uint corner) {
    return adjacency_vertex(adjacency_polygon(v0, v2, v4, lambda, away, adjacency_between(away)), v0, v2, v4, corner);
}
