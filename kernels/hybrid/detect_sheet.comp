// sheet: depths alone. Shadowed where a sheet covers the texel above the receiver; lit where nothing in the column reaches above it.
//                                                                                       [hybrid.md, sound classifiers: sheet]
#include "hybrid/detect.glslh"
#include "column/depth_bounds.glsl"
#include "hybrid/below.glslh"

layout(std430, binding = 9) readonly buffer Sheets { float sheets[]; };
layout(std430, binding = 10) readonly buffer World { vec4 world_and_triangle[]; };

uint detect(Asking asking) {
    uint index = texel_index(asking.texel);
    float end = asking.origin.z - space.margin.z;
    if (sheets[index] + space.margin.y < end) return SHADOWED;
    vec2 centre = texel_centre(asking.texel);
    float half_side = 0.5 + 2.0 * space.margin.x;
    uint number = uint(world_and_triangle[asking.pixel].w) - 1u;
    Own own = own_triangle(place(number, 0u), place(number, 1u), place(number, 2u), asking.origin, centre);
    for (uint node = heads[index]; node != NO_NODE; node = nodes[node].y) {
        uint triangle = nodes[node].x;
        vec3 p[3] = vec3[](place(triangle, 0u), place(triangle, 1u), place(triangle, 2u));
        if (column_depth_bounds(p[0], p[1], p[2], centre, half_side, space.margin.x).x - space.margin.y > end) continue;
        if (own.usable) {
            vec4 plane = column_plane(p[0], p[1], p[2], centre, half_side, space.corner.x);
            if (triangle == number || nowhere_above(own, plane, half_side) || beside(own, p, plane)) continue;
        }
        return UNCERTAIN;
    }
    return LIT;
}
