// What is certain of a ray from `origin` towards the light and one triangle: 0 it misses, 1 it hits beyond tmin, 2 unsure. The ray keeps
// its place across the light; depth grows away from the light. Places across the light may be `margin` wrong, depths `margin_z`.
//                                                                                       [hybrid.md, sound classifiers: exact tests]
#include "column/overlaps.glsl"
#include "column/plane.glsl"

uint column_hit(vec3 a, vec3 b, vec3 c, vec3 origin, float tmin, float margin, float margin_z) {
    vec2 range = vec2(min(min(a.z, b.z), c.z), max(max(a.z, b.z), c.z));
    float end = origin.z - tmin; // what is nearer to the light than this, is hit
    if (range.x - margin_z > end) return 0u;
    if (!column_overlaps(a.xy, b.xy, c.xy, origin.xy, 2.0 * margin)) return 0u;

    vec4 plane = column_plane(a, b, c, origin.xy, margin, margin);
    vec2 z = plane.w < 1.0 / 0.0 ? clamp(vec2(plane.z - plane.w, plane.z + plane.w), range.x, range.y) : range;
    if (z.x - margin_z > end) return 0u;

    precise vec2 pa = a.xy - origin.xy, pb = b.xy - origin.xy, pc = c.xy - origin.xy;
    precise vec2 ab = pb - pa, bc = pc - pb, ca = pa - pc;
    precise vec3 at = vec3(pa.x * ab.y - pa.y * ab.x, pb.x * bc.y - pb.y * bc.x, pc.x * ca.y - pc.y * ca.x);
    vec3 unsure = 2.0 * margin * (abs(vec3(ab.x, bc.x, ca.x)) + abs(vec3(ab.y, bc.y, ca.y)));
    bool inside = all(greaterThan(at, unsure)) || all(lessThan(at, -unsure));
    return inside && z.y + margin_z < end ? 1u : 2u;
}
