// A triangle for the map of grown triangles (BGSM): every edge moved out, depth on its own plane. One that is seen edge-on is
// left out, as the thesis has it.   [thesis 2.2, ch. 4; hybrid.md, convention 9]
#include "hybrid/published.glslh"
#include "conservative/clip_box.glsl"
#include "conservative/depth_at.glsl"
#include "conservative/dilated.glsl"

layout(location = 0) flat out vec4 box;

void main() {
    uint first = uint(gl_VertexIndex) / 3u * 3u;
    vec3 a = published_corner(first), b = published_corner(first + 1u), c = published_corner(first + 2u);
    float lambda = published_lambda();
    box = conservative_clip_box(a.xy, b.xy, c.xy, lambda);
    vec2 p = conservative_dilated(a.xy, b.xy, c.xy, lambda, uint(gl_VertexIndex) - first);
    gl_Position = conservative_is_sliver(a.xy, b.xy, c.xy) ? PUBLISHED_NOWHERE : vec4(p, conservative_depth_at(a, b, c, p), 1.0);
}
