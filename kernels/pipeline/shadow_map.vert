// The scene from the light.
#include "pipeline/frame.glslh"

layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Positions { float positions[]; };
layout(std430, binding = 2) readonly buffer Triangles { uint indices[]; };

layout(location = 0) out float depth;

void main() {
    uint v = 3u * indices[gl_VertexIndex];
    vec4 world = vec4(positions[v], positions[v + 1u], positions[v + 2u], 1.0);
    depth = dot(frame.light_depth, world);
    gl_Position = frame.light * world;
}
