// CRSMA knowing all faces round each vertex, without a geometry shader: twelve vertices a triangle, which a fan of what is left of
// it fills. The same triangles are dropped as in CRSMA: keeping those that nothing lit touches, however short their edges, makes
// up to 17 % of the pixels certain, and hundreds of these wrong (docs/hybrid.md).
// [thesis 4.5; hybrid.md]
#include "hybrid/published.glslh"
#include "adjacency/one_ring.glsl"
#include "conservative/depth_at.glsl"
#include "conservative/erodes_as_published.glsl"

layout(std430, binding = 3) readonly buffer Neighbours { uint neighbours[]; }; // bits 0-2: away, 3-5: inner, 6: faces away

void main() {
    uint triangle = uint(gl_VertexIndex) / 12u, first = 3u * triangle;
    uint bits = neighbours[triangle];
    gl_Position = PUBLISHED_NOWHERE;
    if ((bits & 64u) == 0u) return;
    vec3 v0 = published_corner(first), v2 = published_corner(first + 1u), v4 = published_corner(first + 2u);
    float lambda = published_lambda();
    if (!conservative_erodes_as_published(v0.xy, v2.xy, v4.xy, lambda)) return;
    vec2 p = adjacency_one_ring(v0.xy, v2.xy, v4.xy, lambda, bits & 7u, bits >> 3u & 7u, uint(gl_VertexIndex) % 12u);
    gl_Position = vec4(p, conservative_depth_at(v0, v2, v4, p), 1.0);
}
