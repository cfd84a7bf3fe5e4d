// nearest-8: a sheet above, else the ray against the eight nearest triangles of its column, if the ninth is below the receiver.
//                                                                                       [hybrid.md, sound classifiers: nearest-8]
#include "hybrid/detect.glslh"
#include "column/hit.glsl"
#include "hybrid/nearest.glslh"

layout(std430, binding = 9) readonly buffer Sheets { float sheets[]; };
layout(std430, binding = 10) readonly buffer NearestOf { Nearest nearest_of[]; };

uint detect(Asking asking) {
    uint index = texel_index(asking.texel);
    float end = asking.origin.z - space.margin.z;
    if (sheets[index] + space.margin.y < end) return SHADOWED;
    uint state = nearest_of[index].next - space.margin.y > end ? LIT : UNCERTAIN;
    for (int i = 0; i < KEPT; ++i) {
        uint triangle = nearest_of[index].triangles[i];
        if (triangle == NO_NODE) break;
        uint hit = column_hit(place(triangle, 0u), place(triangle, 1u), place(triangle, 2u), asking.origin, space.margin.z,
                              space.margin.x, space.margin.y);
        if (hit == 1u) return SHADOWED;
        if (hit == 2u) state = UNCERTAIN;
    }
    return state;
}
