// The point on both lines, ab and cd: a + t (b - a), where t is the ratio of the areas that (c - a) and (b - a) span with
// (d - c). `otherwise` if no float says where: the lines are parallel to within rounding, one of them has no direction, or the
// point is too far.   [thesis 2.2.1, lineLineIntersection, which divides by that area whatever it is; docs/decisions.md H2]
#include "conservative/lines.glslh"

vec2 conservative_line_intersection(vec2 a, vec2 b, vec2 c, vec2 d, vec2 otherwise) {
    vec2 along = conservative_direction(b - a), across = conservative_direction(d - c);
    float area = conservative_cross(along, across);
    if (!(abs(area) > conservative_parallel)) return bounded(otherwise);
    float largest = conservative_largest(c - a);
    if (largest == 0.0) return bounded(a);
    precise vec2 point = a + along * (largest * (conservative_cross((c - a) / largest, across) / area));
    return is_finite(point) ? point : bounded(otherwise);
}
