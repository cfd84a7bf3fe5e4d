// Empty columns.
#include "hybrid/columns.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 1) writeonly buffer Farthest { uint farthest[]; };
layout(std430, binding = 2) writeonly buffer BinFarthest { uint bin_farthest[]; };
layout(std430, binding = 3) writeonly buffer Heads { uint heads[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < space.size.x * space.size.x) {
        farthest[i] = 0u;
        heads[i] = NO_NODE;
    }
    if (i < bins_across() * bins_across()) bin_farthest[i] = 0u;
}
