// The nearest and the farthest depth that the triangle can have over the texel p +- half_texel: its plane's at p, less and more
// by what it rises to the texel's corners, and by what the sum may be rounded; never beyond its own corners' depths. Small
// depths are nearer the light. A triangle seen edge-on may be anywhere between its corners.   [docs/decisions.md H14]
#include "conservative/plane.glslh"

vec2 conservative_depth_bounds(vec3 a, vec3 b, vec3 c, vec2 p, vec2 half_texel) {
    vec2 range = vec2(min(a.z, min(b.z, c.z)), max(a.z, max(b.z, c.z)));
    ConservativePlane plane = conservative_plane(a, b, c);
    if (plane.edge_on) return bounded(range);
    vec3 from = conservative_nearest(a, b, c, p);
    precise float depth = from.z + conservative_dot(plane.slope, p - from.xy);
    vec2 reach = abs(half_texel);
    precise float rise = conservative_dot(abs(plane.slope), reach);
    // Twice what plane.slope, the differences, products and sums can be off: 2^-20 of all terms, 2^-22 of from.z.
    precise float rounding = 9.5367431640625e-7 * conservative_dot(plane.terms, abs(p - from.xy) + reach) + 2.384185791015625e-7 * abs(from.z);
    precise vec2 bounds = depth + vec2(-1.0, 1.0) * (rise + rounding);
    if (!is_finite(bounds)) return bounded(range);
    return bounded(clamp(bounds, range.x, range.y));
}
