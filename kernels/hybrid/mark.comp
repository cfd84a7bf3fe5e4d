// Which texels hold receivers: the first pixel to come gives its number as the texel's slot.
#include "hybrid/columns.glslh"
#include "pipeline/frame.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 1) readonly buffer Frames { Frame frame; };
layout(std430, binding = 2) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 3) buffer Slots { uint slots[]; };                 // per texel
layout(std430, binding = 4) writeonly buffer Farthest { uint farthest[]; }; // per slot: farthest.comp
layout(std430, binding = 5) writeonly buffer Heads { uint heads[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint number = pixel.y * frame.size.x + pixel.x;
    farthest[number] = 0u;
    heads[number] = NO_NODE;
    Receiver receiver = receivers[number];
    if (receiver.map.w != 1.0) return;
    ivec2 texel = texel_of(to_column(receiver.origin.xyz).xy);
    if (!in_map(texel)) return;
    uint index = texel_index(texel);
    if (slots[index] == 0u) atomicCompSwap(slots[index], 0u, number + 1u); // looked at first: most come late
}
