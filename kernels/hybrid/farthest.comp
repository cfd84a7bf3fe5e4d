// How far from the light each texel's and each bin's farthest receiver is: what lies beyond it is put into no list.
#include "hybrid/columns.glslh"
#include "pipeline/frame.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 1) readonly buffer Frames { Frame frame; };
layout(std430, binding = 2) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 3) readonly buffer Slots { uint slots[]; };
layout(std430, binding = 4) buffer Farthest { uint farthest[]; };         // per slot, ordered
layout(std430, binding = 5) buffer BinFarthest { uint bin_farthest[]; };  // 0: no receiver

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    Receiver receiver = receivers[pixel.y * frame.size.x + pixel.x];
    if (receiver.map.w != 1.0) return;
    vec3 place = to_column(receiver.origin.xyz);
    ivec2 texel = texel_of(place.xy);
    if (!in_map(texel)) return;
    uint depth = ordered(place.z), slot = slots[texel_index(texel)] - 1u;
    if (farthest[slot] < depth) atomicMax(farthest[slot], depth); // looked at first: most pixels change nothing
    uint bin = bin_index(texel / bin_side());
    if (bin_farthest[bin] < depth) atomicMax(bin_farthest[bin], depth);
}
