// What the geometry stage of CRSMA emits for v0 v2 v4 if the neighbours in `away` face away from the light: one, one, two or four
// triangles for none to three of them, as cases 0 to 3 say; behind these zero-area ones.   [thesis ch. 4]
#include "adjacency/polygon.glslh"

vec2 adjacency_shrunken(vec2 v0, vec2 v2, vec2 v4, float lambda, uint away, uint corner) {
    return adjacency_vertex(adjacency_polygon(v0, v2, v4, lambda, away, adjacency_between(away)), v0, v2, v4, corner);
}
