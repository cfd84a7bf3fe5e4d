// A triangle for CRSMA's map of shrunken triangles (SGSMA): edges towards neighbours that face away from the light stay, the others
// move in; one to four triangles, depth on the plane of the one that they are left of.   [thesis ch. 4; hybrid.md, convention 10]
#include "pipeline/frame.glslh"
#include "hybrid/adjacent.glslh"
#include "conservative/depth_at.glsl"

layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 12) out;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };

void main() {
    vec3 v0 = gl_in[0].gl_Position.xyz, v2 = gl_in[2].gl_Position.xyz, v4 = gl_in[4].gl_Position.xyz;
    float lambda = sqrt(2.0) / float(frame.size.z); // as published_lambda, which binds more
    uint away = adjacency_away(v0.xy, gl_in[1].gl_Position.xy, v2.xy, gl_in[3].gl_Position.xy, v4.xy, gl_in[5].gl_Position.xy);
    uint triangles = adjacent_triangles(v0.xy, v2.xy, v4.xy, lambda, away);
    for (uint i = 0u; i < 3u * triangles; ++i) {
        vec2 p = adjacency_shrunken(v0.xy, v2.xy, v4.xy, lambda, away, i);
        gl_Position = vec4(p, conservative_depth_at(v0, v2, v4, p), 1.0);
        EmitVertex();
        if (i % 3u == 2u) EndPrimitive();
    }
}
