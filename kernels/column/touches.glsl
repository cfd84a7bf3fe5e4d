// Whether the segment ab meets a square round `centre`: false only where an axis separates them.   [hybrid.md, sound classifiers: sheet]
bool column_touches(vec2 a, vec2 b, vec2 centre, float half_side) {
    precise vec2 pa = a - centre, pb = b - centre, ab = pb - pa;
    if (any(greaterThan(min(pa, pb), vec2(half_side))) || any(lessThan(max(pa, pb), vec2(-half_side)))) return false;
    precise float at = pa.x * ab.y - pa.y * ab.x;
    return !(abs(at) > half_side * (abs(ab.x) + abs(ab.y)));
}
