// No receivers yet.
#include "hybrid/columns.glslh"
#include "pipeline/linear.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Slots { uint slots[]; };
layout(std430, binding = 2) writeonly buffer BinFarthest { uint bin_farthest[]; };

void main() {
    uint i = linear_index();
    if (i < space.size.x * space.size.x) slots[i] = 0u;
    if (i < space.bins.y * space.bins.y) bin_farthest[i] = 0u;
}
