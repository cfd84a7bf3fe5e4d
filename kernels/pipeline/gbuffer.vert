// Pulls a triangle's corners; the fragment learns where it is in the world and which triangle it is on.
#include "pipeline/frame.glslh"

layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Positions { float positions[]; };
layout(std430, binding = 2) readonly buffer Normals { float normals[]; };
layout(std430, binding = 3) readonly buffer Triangles { uint indices[]; };

layout(location = 0) out vec3 world;
layout(location = 1) out vec3 normal;
layout(location = 2) flat out float triangle; // its number + 1, so that 0 is the background

void main() {
    uint v = 3u * indices[gl_VertexIndex];
    world = vec3(positions[v], positions[v + 1u], positions[v + 2u]);
    normal = vec3(normals[v], normals[v + 1u], normals[v + 2u]);
    triangle = float(gl_VertexIndex / 3 + 1);
    gl_Position = frame.camera * vec4(world, 1.0);
}
