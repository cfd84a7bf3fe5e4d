// A triangle for CRSM's map of shrunken triangles (SGSM): every edge moved in, depth on its own plane.
// [thesis 2.2, ch. 4; hybrid.md, convention 9]
#include "hybrid/published.glslh"
#include "conservative/depth_at.glsl"
#include "conservative/eroded.glsl"
#include "conservative/erodes_as_published.glsl"

void main() {
    uint first = uint(gl_VertexIndex) / 3u * 3u;
    vec3 a = published_corner(first), b = published_corner(first + 1u), c = published_corner(first + 2u);
    float lambda = published_lambda();
    vec2 p = conservative_eroded(a.xy, b.xy, c.xy, lambda, uint(gl_VertexIndex) - first);
    gl_Position = conservative_erodes_as_published(a.xy, b.xy, c.xy, lambda)
                      ? vec4(p, conservative_depth_at(a, b, c, p), 1.0)
                      : PUBLISHED_NOWHERE;
}
