// Where a point of the map lies on a triangle's projection: 0 certainly within, 8 certainly outside, else the bits 1, 2 and 4 of the
// edges ab, bc and ca that it is too near to say, of those that it may be within. Places may be `margin` wrong. One edge's bit alone: the
// point is within if it is on that edge's inner side, and the third corner certainly is.
//                                                                                       [hybrid.md, sound classifiers: exact tests]
#include "column/overlaps.glsl"

uint column_coverage(vec2 a, vec2 b, vec2 c, vec2 p, float margin) {
    precise vec2 pa = a - p, pb = b - p, pc = c - p;
    // Four roundings of the distance are what the products below are good to: 2^-21 is twice that, where the margin leaves less.
    vec2 far = max(max(abs(pa), abs(pb)), abs(pc));
    float off = 2.0 * margin, least = 4.76837158203125e-7 * max(far.x, far.y);
    if (off < least) off = least; // not max, which may leave out a NaN
    if (!column_overlaps(a, b, c, p, off)) return 8u;
    // From the corners themselves: the differences to a point far away are too coarse for a short edge's direction.
    precise vec2 ab = b - a, bc = c - b, ca = a - c;
    precise vec3 at = vec3(pa.x * ab.y - pa.y * ab.x, pb.x * bc.y - pb.y * bc.x, pc.x * ca.y - pc.y * ca.x);
    vec3 unsure = off * (abs(vec3(ab.x, bc.x, ca.x)) + abs(vec3(ab.y, bc.y, ca.y))) + 1e-37; // below which products vanish
    // Within, the point is on the same side of all edges: on the side that most of the area says.
    if (at.x + at.y + at.z < 0.0) at = -at;
    return (at.x > unsure.x ? 0u : 1u) | (at.y > unsure.y ? 0u : 2u) | (at.z > unsure.z ? 0u : 4u);
}
