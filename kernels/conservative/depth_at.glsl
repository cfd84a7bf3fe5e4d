// The depth z of the triangle's plane at p. A triangle seen edge-on has its nearest corner's everywhere.   [docs/hybrid.md]
#include "conservative/plane.glslh"

float conservative_depth_at(vec3 a, vec3 b, vec3 c, vec2 p) {
    ConservativePlane plane = conservative_plane(a, b, c);
    if (plane.edge_on) return bounded(min(a.z, min(b.z, c.z)));
    return bounded(conservative_depth_from(plane, conservative_nearest(a, b, c, p), p));
}
