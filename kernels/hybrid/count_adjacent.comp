// How many triangles the geometry stage emits, which it cannot count itself on every device.
#include "hybrid/published.glslh"
#include "hybrid/adjacent.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 3) buffer Total { uint total; };

void main() {
    uint triangle = gl_GlobalInvocationID.x;
    if (6u * triangle >= uint(indices.length())) return;
    vec2 v[6];
    for (uint i = 0u; i < 6u; ++i) v[i] = published_corner(6u * triangle + i).xy;
    uint away = adjacency_away(v[0], v[1], v[2], v[3], v[4], v[5]);
    atomicAdd(total, adjacent_triangles(v[0], v[2], v[4], published_lambda(), away));
}
