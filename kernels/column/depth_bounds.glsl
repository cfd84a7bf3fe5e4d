// The nearest and the farthest that a triangle can be over a square round `centre`: its plane's range over the square, within its own.
// Depth grows away from the light. A triangle too thin for a plane has its whole range.   [hybrid.md, soundness: depth]
#include "column/plane.glsl"

vec2 column_depth_bounds(vec3 a, vec3 b, vec3 c, vec2 centre, float half_side, float margin) {
    vec2 range = vec2(min(min(a.z, b.z), c.z), max(max(a.z, b.z), c.z));
    if (!(range.x <= range.y)) return vec2(-1.0 / 0.0, 1.0 / 0.0); // no depth at all: it may be anywhere
    vec4 plane = column_plane(a, b, c, centre, half_side, margin);
    float reach = half_side * (abs(plane.x) + abs(plane.y)) + plane.w;
    float nearest = plane.z - reach, farthest = plane.z + reach;
    return vec2(nearest > range.x ? min(nearest, range.y) : range.x, farthest < range.y ? max(farthest, range.x) : range.y);
}
