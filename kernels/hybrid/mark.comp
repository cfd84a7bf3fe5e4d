// Which texels hold receivers, and how far from the light each texel's and each bin's farthest is: nothing else is put into a list, nor
// what lies beyond it. The first pixel to come gives its number as the texel's slot.
#include "hybrid/columns.glslh"
#include "pipeline/frame.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 1) readonly buffer Frames { Frame frame; };
layout(std430, binding = 2) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 3) buffer Slots { uint slots[]; };              // per texel
layout(std430, binding = 4) buffer Farthest { uint farthest[]; };        // per slot, ordered; 0: no texel's slot
layout(std430, binding = 5) buffer BinFarthest { uint bin_farthest[]; }; // 0: no receiver
layout(std430, binding = 6) buffer Masks { uint masks[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint number = pixel.y * frame.size.x + pixel.x;
    if (receivers[number].map.w != 1.0) return;
    vec3 place = to_column(receivers[number].origin.xyz);
    ivec2 texel = texel_of(place.xy);
    if (!in_map(texel)) return;
    uint index = texel_index(texel), depth = ordered(place.z);
    // Everything is looked at before it is changed: most pixels change nothing.
    uint slot = slots[index];
    if (slot == 0u) {
        slot = atomicCompSwap(slots[index], 0u, number + 1u);
        if (slot == 0u) slot = number + 1u;
        atomicOr(masks[uint(texel.y / 4) * words_across() + uint(texel.x / 8)], 1u << uint(8 * (texel.y % 4) + texel.x % 8));
    }
    if (farthest[slot - 1u] >= depth) return;
    atomicMax(farthest[slot - 1u], depth);
    uint bin = bin_index(texel / bin_side());
    if (bin_farthest[bin] < depth) atomicMax(bin_farthest[bin], depth);
}
