// The point on both lines, ab and cd: from the end of ab that is nearer to it, v, on by t (b - a), where t is the ratio of the
// areas that (c - v) and (b - a) span with (d - c). Roundings of a long way would be seen where it ends. `otherwise` if the
// lines are parallel to within rounding, one of them has no direction, or the way there is too long for a float.
// [thesis 2.2.1, lineLineIntersection, which starts at a and divides by that area whatever it is; docs/decisions.md H2]
#include "conservative/lines.glslh"

// By a power of two, so that nothing is rounded, to between 1/2 and 1 along its longer axis. Of edges beyond 2^125, and below
// 2^-127, GLSL does not say so; they may come out as none.
vec2 conservative_scaled(vec2 e) {
    int exponent;
    frexp(conservative_largest(e), exponent);
    return ldexp(e, ivec2(-exponent));
}

vec2 conservative_line_intersection(vec2 a, vec2 b, vec2 c, vec2 d, vec2 otherwise) {
    vec2 along = conservative_scaled(b - a), across = conservative_scaled(d - c);
    float area = conservative_cross(along, across);
    float lengths = sqrt(conservative_dot(along, along) * conservative_dot(across, across));
    if (!(abs(area) > conservative_parallel * lengths)) return bounded(otherwise);
    float from_a = conservative_cross(c - a, across), from_b = conservative_cross(c - b, across);
    bool is_nearer_to_b = abs(from_b) < abs(from_a);
    vec2 start = is_nearer_to_b ? b : a;
    precise vec2 point = start + along * ((is_nearer_to_b ? from_b : from_a) / area);
    return is_finite(point) ? point : bounded(otherwise);
}
