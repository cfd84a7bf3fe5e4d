// The nearest and the farthest depth that the triangle can have over the texel p +- half_texel: its plane's at p, less and more
// by what it rises to the texel's corners, and by what the sum may be rounded; never beyond its own corners' depths. Small
// depths are nearer the light. A triangle seen edge-on may be anywhere between its corners.   [docs/decisions.md H14]
#include "conservative/plane.glslh"

vec2 conservative_depth_bounds(vec3 a, vec3 b, vec3 c, vec2 p, vec2 half_texel) {
    vec2 range = vec2(min(a.z, min(b.z, c.z)), max(a.z, max(b.z, c.z)));
    ConservativePlane plane = conservative_plane(a, b, c);
    if (plane.edge_on) return bounded(range);
    vec3 from = conservative_nearest(a, b, c, p);
    float depth = conservative_depth_from(plane, from, p);
    vec2 reach = abs(half_texel);
    precise vec2 slope = plane.rise * plane.along + plane.across * vec2(-plane.along.y, plane.along.x);
    precise float rise = conservative_dot(abs(slope), reach);
    // Twice what all of this can be off, 2^-20 of every term: the way from the corner, over the texel too, times the rises, and the part
    // of it that leads across times what the rise across was made of.
    float way = conservative_length(p - from.xy) + conservative_length(reach);
    float aside = abs(conservative_cross(plane.along, p - from.xy)) + conservative_dot(abs(plane.along.yx), reach);
    precise float rounding = 9.5367431640625e-7 * ((abs(plane.rise) + abs(plane.across)) * way + plane.across_terms * aside + abs(from.z));
    precise vec2 bounds = depth + vec2(-1.0, 1.0) * (rise + rounding);
    if (!is_finite(bounds)) return bounded(range);
    return bounded(clamp(bounds, range.x, range.y));
}
