// lists: the ray against every triangle of its column. Only what grazes a silhouette, a corner or the origin stays uncertain.
//                                                                                       [hybrid.md, sound classifiers: lists]
#include "hybrid/detect.glslh"
#include "hybrid/hit_triangle.glslh"
#include "hybrid/walk.glslh"

layout(std430, binding = 10) readonly buffer Rings { uint next_half_edge[]; };

uint next_of(uint half_edge) { return next_half_edge[half_edge]; }

uint detect(Asking asking) {
    float end = asking.origin.z - space.receiver.z;
    uint state = LIT;
    Walk walk = first_above(asking.slot, end + space.receiver.y);
    for (; is_on(walk); walk = next_above(walk, end + space.receiver.y)) {
        uint hit = hit_triangle(nodes[walk.node].triangle, asking.origin);
        if (hit == 1u) return SHADOWED;
        if (hit == 2u) state = UNCERTAIN;
    }
    return is_complete(walk) ? state : UNCERTAIN;
}
