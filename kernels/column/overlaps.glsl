// Whether a triangle meets a square round `centre`: false only where an axis separates them, so that no texel is missed. Lines are
// compared by the intervals that both cover across them, which needs no winding: a triangle seen edge-on is its longest side.
//                                                                                       [hybrid.md, sound classifiers: the column]
bool column_overlaps(vec2 a, vec2 b, vec2 c, vec2 centre, float half_side) {
    precise vec2 pa = a - centre, pb = b - centre, pc = c - centre;
    if (any(greaterThan(min(min(pa, pb), pc), vec2(half_side))) || any(lessThan(max(max(pa, pb), pc), vec2(-half_side)))) return false;
    precise vec2 ab = pb - pa, bc = pc - pb, ca = pa - pc;
    // Twice the area: of each edge with the next, not of any two, whose rounding a third edge may be too short for. And of the triangles
    // that each makes with the centre.
    precise vec3 area = vec3(ab.x * bc.y - ab.y * bc.x, bc.x * ca.y - bc.y * ca.x, ca.x * ab.y - ca.y * ab.x);
    precise vec3 at = vec3(pa.x * ab.y - pa.y * ab.x, pb.x * bc.y - pb.y * bc.x, pc.x * ca.y - pc.y * ca.x);
    vec3 reach = half_side * (abs(vec3(ab.x, bc.x, ca.x)) + abs(vec3(ab.y, bc.y, ca.y)));
    return !(any(greaterThan(at - reach, max(area, vec3(0.0)))) || any(lessThan(at + reach, min(area, vec3(0.0)))));
}
