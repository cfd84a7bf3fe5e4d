// A triangle's plane round a point of the map: (dz/dx, dz/dy, z, how far z may be wrong) within `half_side` of the point, when each
// corner may be `margin` away from its true place across the light. Planes through corners moved by m differ at the corners by
// |gradient| m, and elsewhere by that times the sum of the absolute barycentric weights. A triangle too thin to say has an infinite
// error.                                                                                                 [hybrid.md, soundness: depth]
vec4 column_plane(vec3 a, vec3 b, vec3 c, vec2 at, float half_side, float margin) {
    precise vec2 pa = a.xy - at, pb = b.xy - at, pc = c.xy - at;
    // Rounding these three moves the corners, as the point sees them, by 2^-24 of how far they are: no margin is less.
    vec2 far = max(max(abs(pa), abs(pb)), abs(pc));
    float least = 5.9604644775390625e-8 * max(far.x, far.y);
    margin = margin < least ? least : margin; // not max, which may leave out a NaN
    // The sides are not moved by that.
    precise vec3 ab = b - a, bc = c - b, ca = a - c;
    precise float area = ab.x * -ca.y + ab.y * ca.x;
    vec3 sides = abs(vec3(ab.x, bc.x, ca.x)) + abs(vec3(ab.y, bc.y, ca.y));
    float longest = max(max(sides.x, sides.y), sides.z);
    if (!(abs(area) > 64.0 * margin * longest && abs(area) < 1.0 / 0.0)) return vec4(0.0, 0.0, 0.0, 1.0 / 0.0);
    // Areas of the triangles that each side makes with the point: the weights, times the area. Their sum is 1 or more, but for what
    // rounding does to the area of the thinnest triangles, some 1/64 of it, and so to their gradient: twice the margin covers both.
    precise vec3 parts = vec3(pa.x * ab.y - pa.y * ab.x, pb.x * bc.y - pb.y * bc.x, pc.x * ca.y - pc.y * ca.x);
    float weights = (dot(abs(parts), vec3(1.0)) + half_side * (sides.x + sides.y + sides.z)) / abs(area);
    precise vec2 gradient = vec2(ca.z * ab.y - ab.z * ca.y, ab.z * ca.x - ca.z * ab.x) / area;
    precise float z = a.z - (gradient.x * pa.x + gradient.y * pa.y);
    float wrong = 2.0 * margin * (abs(gradient.x) + abs(gradient.y)) * weights;
    // And the arithmetic's own, here and in a ray tracer: products of long sides, whose difference is the area of a thin triangle, carry
    // 2^-24 of themselves into the slope, and the slope takes it as far as the farthest corner. Three times what was met.
    float farthest = max(max(abs(pa.x) + abs(pa.y), abs(pb.x) + abs(pb.y)), abs(pc.x) + abs(pc.y)) + half_side;
    float rise = max(max(a.z, b.z), c.z) - min(min(a.z, b.z), c.z);
    wrong += 1.1920928955078125e-7 * rise * (longest / abs(area)) * farthest; // 2^-23
    return abs(z) + wrong < 1.0 / 0.0 ? vec4(gradient, z, wrong) : vec4(0.0, 0.0, 0.0, 1.0 / 0.0);
}
