// nearest-8: the ray against the eight nearest triangles of its column, if the ninth is below the receiver; else a sheet above.
//                                                                                       [hybrid.md, sound classifiers: nearest-8]
#include "hybrid/detect.glslh"
#include "hybrid/sheet.glslh"
#include "hybrid/hit_triangle.glslh"
#include "hybrid/nearest.glslh"

layout(std430, binding = 11) readonly buffer NearestOf { Nearest nearest_of[]; };

uint detect(Asking asking) {
    float end = asking.origin.z - space.receiver.z;
    uint state = nearest_of[asking.slot].next - space.receiver.y > end ? LIT : UNCERTAIN;
    int i = 0;
    for (; i < KEPT && nearest_of[asking.slot].triangles[i] != NO_NODE; ++i) {
        uint triangle = nearest_of[asking.slot].triangles[i];
        uint hit = hit_triangle(triangle, asking.origin);
        if (hit == 1u) return SHADOWED;
        if (hit == 2u) state = UNCERTAIN;
    }
    if (i < KEPT && nearest_of[asking.slot].triangles[i] != NO_NODE) state = UNCERTAIN; // the loop was left
    return state == LIT || !under_sheet(asking.slot, asking.texel, end - space.receiver.y) ? state : SHADOWED;
}
