// No receivers yet.
#include "hybrid/columns.glslh"
#include "pipeline/linear.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Slots { uint slots[]; };              // per texel
layout(std430, binding = 2) writeonly buffer BinFarthest { uint bin_farthest[]; }; // per bin
layout(std430, binding = 3) writeonly buffer Masks { uint masks[]; };
layout(std430, binding = 4) writeonly buffer Farthest { uint farthest[]; };        // per pixel
layout(std430, binding = 5) writeonly buffer Heads { uint heads[]; };              // per pixel
layout(push_constant) uniform Constants { uint pixels; };

void main() {
    uint i = linear_index();
    if (i < space.size.x * space.size.x) slots[i] = 0u;
    if (i < space.bins.y * space.bins.y) bin_farthest[i] = 0u;
    if (i < words_across() * ((space.size.x + 3u) / 4u)) masks[i] = 0u;
    if (i >= pixels) return;
    farthest[i] = 0u;
    heads[i] = NO_NODE;
}
