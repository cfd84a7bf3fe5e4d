// What is certain of a ray from `origin` towards the light and one triangle: 0 it misses, 1 it hits beyond tmin, 2 unsure. The ray keeps
// its place across the light; depth grows away from the light. Places across the light may be `margin` wrong, depths `margin_z`.
//                                                                                       [hybrid.md, sound classifiers: exact tests]
#include "column/coverage.glsl"
#include "column/height.glsl"

uint column_hit(vec3 a, vec3 b, vec3 c, vec3 origin, float tmin, float margin, float margin_z) {
    uint coverage = column_coverage(a.xy, b.xy, c.xy, origin.xy, margin);
    if (coverage == 8u) return 0u;
    uint height = column_height(a, b, c, origin, tmin, margin, margin_z);
    return height == 1u && coverage != 0u ? 2u : height;
}
