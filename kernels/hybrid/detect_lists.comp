// lists: the ray against every triangle of its column. Only what grazes an edge or the origin stays uncertain.
//                                                                                       [hybrid.md, sound classifiers: lists]
#include "hybrid/detect.glslh"
#include "column/hit.glsl"

uint detect(Asking asking) {
    uint state = LIT;
    for (uint node = heads[texel_index(asking.texel)]; node != NO_NODE; node = nodes[node].y) {
        uint triangle = nodes[node].x;
        uint hit = column_hit(place(triangle, 0u), place(triangle, 1u), place(triangle, 2u), asking.origin, space.margin.z,
                              space.margin.x, space.margin.y);
        if (hit == 1u) return SHADOWED;
        if (hit == 2u) state = UNCERTAIN;
    }
    return state;
}
