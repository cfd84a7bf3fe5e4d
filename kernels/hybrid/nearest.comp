// For every texel that holds a receiver, by its slot: the eight triangles of its column that reach nearest to the light, and how near
// the ninth does. Equally near ones in the order of their numbers, so that the lists' order does not matter.
//                                                                                       [hybrid.md, sound classifiers: nearest-8]
#include "hybrid/columns.glslh"
#include "hybrid/nearest.glslh"
#include "hybrid/node.glslh"
#include "pipeline/frame.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 1) readonly buffer Farthest { uint farthest[]; };
layout(std430, binding = 2) readonly buffer Heads { uint heads[]; };
layout(std430, binding = 3) readonly buffer Nodes { Node nodes[]; };
layout(std430, binding = 4) writeonly buffer NearestOf { Nearest nearest_of[]; };
layout(std430, binding = 5) readonly buffer Frames { Frame frame; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint slot = pixel.y * frame.size.x + pixel.x;
    if (farthest[slot] == 0u) return; // no texel's slot
    float depths[KEPT];
    Nearest nearest;
    for (int i = 0; i < KEPT; ++i) {
        depths[i] = 1.0 / 0.0;
        nearest.triangles[i] = NO_NODE;
    }
    nearest.next = 1.0 / 0.0;
    int length = 0;
    uint node = heads[slot];
    for (; node != NO_NODE && length < LONGEST; node = nodes[node].next, ++length) {
        uint triangle = nodes[node].triangle;
        float depth = nodes[node].nearest;
        // Sink it into the sorted eight; what falls out is the ninth so far.
        for (int i = 0; i < KEPT; ++i) {
            bool before = depth < depths[i] || depth == depths[i] && triangle < nearest.triangles[i];
            if (!before) continue;
            float d = depths[i];
            uint other = nearest.triangles[i];
            depths[i] = depth;
            nearest.triangles[i] = triangle;
            depth = d;
            triangle = other;
        }
        nearest.next = min(nearest.next, depth);
    }
    if (node != NO_NODE) nearest.next = -1.0 / 0.0; // whatever else there is
    nearest_of[slot] = nearest;
}
