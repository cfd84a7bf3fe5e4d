// How many of the pixels that a technique's kernel is asked about are of which of its cases.
#include "pipeline/shadow_map.glslh"
#include <technique>

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 3) buffer Census { uint pixels_of[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    receiver = receivers[pixel.y * frame.size.x + pixel.x];
    if (receiver.map.w != 1.0 || !receiver_in_map()) return;
    uint number = min(technique_number(receiver_texel()), uint(pixels_of.length()) - 1u);
    atomicAdd(pixels_of[number], 1u);
}
