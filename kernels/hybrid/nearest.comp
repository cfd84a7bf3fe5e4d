// For every texel that holds a receiver: the eight triangles of its column that reach nearest to the light, and how near the ninth
// does. Equally near ones in the order of their numbers, so that the lists' order does not matter.
//                                                                                       [hybrid.md, sound classifiers: nearest-8]
#include "column/depth_bounds.glsl"
#include "hybrid/columns.glslh"
#include "hybrid/nearest.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 1) readonly buffer Places { vec4 places[]; };
layout(std430, binding = 2) readonly buffer Triangles { uint indices[]; };
layout(std430, binding = 3) readonly buffer Farthest { uint farthest[]; };
layout(std430, binding = 4) readonly buffer Heads { uint heads[]; };
layout(std430, binding = 5) readonly buffer Nodes { uvec2 nodes[]; };
layout(std430, binding = 6) writeonly buffer NearestOf { Nearest nearest_of[]; };

vec3 place(uint triangle, uint k) { return places[indices[3u * triangle + k]].xyz; }

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (!in_map(texel)) return;
    uint index = texel_index(texel);
    if (farthest[index] == 0u) return;
    float depths[KEPT];
    Nearest nearest;
    for (int i = 0; i < KEPT; ++i) {
        depths[i] = 1.0 / 0.0;
        nearest.triangles[i] = NO_NODE;
    }
    nearest.next = 1.0 / 0.0;
    vec2 centre = texel_centre(texel);
    for (uint node = heads[index]; node != NO_NODE; node = nodes[node].y) {
        uint triangle = nodes[node].x;
        float depth = column_depth_bounds(place(triangle, 0u), place(triangle, 1u), place(triangle, 2u), centre,
                                          0.5 + 2.0 * space.margin.x, space.margin.x).x;
        // Sink it into the sorted eight; what falls out is the ninth so far.
        for (int i = 0; i < KEPT; ++i) {
            bool before = depth < depths[i] || depth == depths[i] && triangle < nearest.triangles[i];
            if (!before) continue;
            float d = depths[i];
            uint t = nearest.triangles[i];
            depths[i] = depth;
            nearest.triangles[i] = triangle;
            depth = d;
            triangle = t;
        }
        nearest.next = min(nearest.next, depth);
    }
    nearest_of[index] = nearest;
}
