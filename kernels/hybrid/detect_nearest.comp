// nearest-8: a sheet above, else the ray against the eight nearest triangles of its column, if the ninth is below the receiver.
//                                                                                       [hybrid.md, sound classifiers: nearest-8]
#include "hybrid/detect.glslh"
#include "hybrid/hit_triangle.glslh"
#include "hybrid/nearest.glslh"

layout(std430, binding = 8) readonly buffer Sheets { float sheets[]; };
layout(std430, binding = 9) readonly buffer NearestOf { Nearest nearest_of[]; };
layout(std430, binding = 10) readonly buffer Rings { uint next_half_edge[]; };

uint next_of(uint half_edge) { return next_half_edge[half_edge]; }

uint detect(Asking asking) {
    float end = asking.origin.z - space.receiver.z;
    if (sheets[asking.slot] + space.receiver.y < end) return SHADOWED;
    uint state = nearest_of[asking.slot].next - space.receiver.y > end ? LIT : UNCERTAIN;
    for (int i = 0; i < KEPT; ++i) {
        uint triangle = nearest_of[asking.slot].triangles[i];
        if (triangle == NO_NODE) break;
        uint hit = hit_triangle(triangle, asking.origin);
        if (hit == 1u) return SHADOWED;
        if (hit == 2u) state = UNCERTAIN;
    }
    return state;
}
