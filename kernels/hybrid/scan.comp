// Where each tile's rays begin: a running sum in the tiles' order, so that the same pixel gets the same ray on any device.
// One thread: a frame has thousands of tiles, not millions.
#include "pipeline/frame.glslh"
#include "hybrid/tile.glslh"

layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) buffer Counts { uvec2 counts[]; };   // in: rays per tile; out: rays before it
layout(std430, binding = 2) writeonly buffer Totals { uvec2 totals; };

void main() {
    if (gl_GlobalInvocationID.x > 0u) return;
    uvec2 tiles = tile_count(frame.size.xy);
    uvec2 sum = uvec2(0u);
    for (uint tile = 0u; tile < tiles.x * tiles.y; ++tile) {
        uvec2 count = counts[tile];
        counts[tile] = sum;
        sum += count;
    }
    totals = sum;
}
