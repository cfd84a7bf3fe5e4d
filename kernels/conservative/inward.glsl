// The unit normal of the edge from a to b, (-e_y, e_x) normalised, turned towards the side that `inside` lies on; left of the
// edge if it lies on neither, (0, 0) if a is b.   [thesis eq. 2 prints (-e_x, e_y), which is no perpendicular; docs/decisions.md H1]
#include "conservative/lines.glslh"

vec2 conservative_inward(vec2 a, vec2 b, vec2 inside) {
    vec2 along = conservative_direction(b - a);
    vec2 normal = vec2(-along.y, along.x);
    return clamp(bounded(conservative_dot(normal, conservative_direction(inside - a)) < 0.0 ? -normal : normal), -1.0, 1.0);
}
