// Whether a triangle is between a ray's origin and the light where the ray passes it, should it pass: 0 certainly not (nowhere nearer to
// the light than the origin by more than tmin), 1 certainly, 2 unsure. Places across the light may be `margin` wrong, depths `margin_z`.
//                                                                                       [hybrid.md, sound classifiers: exact tests]
#include "column/plane.glsl"

uint column_height(vec3 a, vec3 b, vec3 c, vec3 origin, float tmin, float margin, float margin_z) {
    float end = origin.z - tmin; // what is nearer to the light than this, is hit
    vec2 range = vec2(min(min(a.z, b.z), c.z), max(max(a.z, b.z), c.z));
    // Of depths, too, rounding leaves no less than this unsure: that of `end`, and of a plane's depth, which is a sum.
    float least = 2.384185791015625e-7 * max(max(abs(range.x), abs(range.y)), abs(origin.z) + abs(tmin)); // 2^-22
    margin_z = margin_z < least ? least : margin_z; // not max, which may leave out a NaN
    if (range.x - margin_z > end) return 0u;
    if (range.y + margin_z < end) return 1u;
    vec4 plane = column_plane(a, b, c, origin.xy, margin, margin);
    if (plane.z - plane.w - margin_z > end) return 0u; // none without a plane, which is wrong by infinity
    return plane.z + plane.w + margin_z < end ? 1u : 2u;
}
