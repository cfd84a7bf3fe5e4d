// Where a point of the map lies on a triangle's projection: 0 certainly within, 8 certainly outside, else the bits 1, 2 and 4 of the
// edges ab, bc and ca that it is too near to say, of those that it may be within. Places may be `margin` wrong.
//                                                                                       [hybrid.md, sound classifiers: exact tests]
#include "column/overlaps.glsl"

uint column_coverage(vec2 a, vec2 b, vec2 c, vec2 p, float margin) {
    if (!column_overlaps(a, b, c, p, 2.0 * margin)) return 8u;
    precise vec2 pa = a - p, pb = b - p, pc = c - p, ab = pb - pa, bc = pc - pb, ca = pa - pc;
    precise vec3 at = vec3(pa.x * ab.y - pa.y * ab.x, pb.x * bc.y - pb.y * bc.x, pc.x * ca.y - pc.y * ca.x);
    vec3 unsure = 2.0 * margin * (abs(vec3(ab.x, bc.x, ca.x)) + abs(vec3(ab.y, bc.y, ca.y)));
    // Within, the point is on the same side of all edges: on the side that most of the area says.
    if (at.x + at.y + at.z < 0.0) at = -at;
    return (at.x > unsure.x ? 0u : 1u) | (at.y > unsure.y ? 0u : 2u) | (at.z > unsure.z ? 0u : 4u);
}
