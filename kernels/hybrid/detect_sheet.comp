// sheet: depths alone. Lit where nothing in the column reaches above the receiver; shadowed where a sheet covers the texel above it.
//                                                                                       [hybrid.md, sound classifiers: sheet]
#include "hybrid/detect.glslh"
#include "hybrid/below.glslh"
#include "hybrid/sheet.glslh"

layout(std430, binding = 11) readonly buffer World { vec4 world_and_triangle[]; };

/// Whether nothing in the column lies between the receiver and the light, wherever in the column they are.
bool under_nothing(Asking asking, float end) {
    vec2 centre = texel_centre(asking.texel);
    uint number = uint(world_and_triangle[asking.pixel].w) - 1u;
    Own own = own_triangle(solid(number), asking.origin, centre);
    Walk walk = first_above(asking.slot, end + space.receiver.y);
    for (; is_on(walk); walk = next_above(walk, end + space.receiver.y)) {
        uint triangle = nodes[walk.node].triangle;
        if (!own.usable) return false;
        if (triangle == number) continue;
        Solid t = solid(triangle);
        vec4 plane = plane_of(t, centre);
        if (!(known_well(plane, t) && nowhere_above(own, t, plane) || beside(own, t, plane, asking.origin.xy))) return false;
    }
    return is_complete(walk);
}

uint detect(Asking asking) {
    float end = asking.origin.z - space.receiver.z;
    if (under_nothing(asking, end)) return LIT;
    return under_sheet(asking.slot, asking.texel, end - space.receiver.y) ? SHADOWED : UNCERTAIN;
}
