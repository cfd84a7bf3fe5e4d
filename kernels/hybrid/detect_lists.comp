// lists: the ray against every triangle of its column. Only what grazes a silhouette, a corner or the origin stays uncertain.
//                                                                                       [hybrid.md, sound classifiers: lists]
#include "hybrid/detect.glslh"
#include "hybrid/hit_triangle.glslh"
#include "hybrid/node.glslh"

layout(std430, binding = 8) readonly buffer Heads { uint heads[]; };
layout(std430, binding = 9) readonly buffer Nodes { Node nodes[]; };
layout(std430, binding = 10) readonly buffer Rings { uint next_half_edge[]; };

uint next_of(uint half_edge) { return next_half_edge[half_edge]; }

uint detect(Asking asking) {
    float end = asking.origin.z - space.receiver.z;
    uint state = LIT;
    int length = 0;
    for (uint node = heads[asking.slot]; node != NO_NODE; node = nodes[node].next) {
        if (++length > LONGEST) return UNCERTAIN;
        if (nodes[node].nearest - space.receiver.y > end) continue; // nowhere above the receiver
        uint hit = hit_triangle(nodes[node].triangle, asking.origin);
        if (hit == 1u) return SHADOWED;
        if (hit == 2u) state = UNCERTAIN;
    }
    return state;
}
