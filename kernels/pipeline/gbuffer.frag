// World position and triangle, shading normal. Everything else is computed from these, once, for every technique alike.
layout(location = 0) in vec3 world;
layout(location = 1) in vec3 normal;
layout(location = 2) flat in float triangle;

layout(location = 0) out vec4 world_and_triangle;
layout(location = 1) out vec4 shading_normal;

void main() {
    world_and_triangle = vec4(world, triangle);
    shading_normal = vec4(normal, 0.0);
}
