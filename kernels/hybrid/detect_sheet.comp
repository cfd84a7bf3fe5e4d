// sheet: depths alone. Shadowed where a sheet covers the texel above the receiver; lit where nothing in the column reaches above it.
//                                                                                       [hybrid.md, sound classifiers: sheet]
#include "hybrid/detect.glslh"
#include "column/depth_bounds.glsl"
#include "hybrid/below.glslh"

layout(std430, binding = 8) readonly buffer Heads { uint heads[]; };
layout(std430, binding = 9) readonly buffer Nodes { uvec2 nodes[]; };
layout(std430, binding = 10) readonly buffer Sheets { float sheets[]; };
layout(std430, binding = 11) readonly buffer World { vec4 world_and_triangle[]; };

uint detect(Asking asking) {
    float end = asking.origin.z - space.receiver.z;
    if (sheets[asking.slot] + space.receiver.y < end) return SHADOWED;
    vec2 centre = texel_centre(asking.texel);
    uint number = uint(world_and_triangle[asking.pixel].w) - 1u;
    Own own = own_triangle(solid(number), asking.origin, centre);
    int length = 0;
    for (uint node = heads[asking.slot]; node != NO_NODE; node = nodes[node].y) {
        if (++length > LONGEST) return UNCERTAIN;
        uint triangle = nodes[node].x;
        Solid t = solid(triangle);
        if (column_depth_bounds(t.p[0], t.p[1], t.p[2], centre, half_texel(t), t.margin).x - t.margin_z > end) continue;
        if (own.usable) {
            if (triangle == number) continue;
            vec4 plane = plane_of(t, centre);
            if (known_well(plane, t) && nowhere_above(own, t, plane) || beside(own, t, plane, asking.origin.xy)) continue;
        }
        return UNCERTAIN;
    }
    return LIT;
}
