// How many rays each tile of pixels needs, and how many of its pixels face the light.
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"
#include "hybrid/state.glslh"
#include "hybrid/tile.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 2) readonly buffer States { uint states[]; };
layout(std430, binding = 3) writeonly buffer Counts { uvec2 counts[]; }; // rays, pixels that face the light

void main() {
    uvec2 tiles = tile_count(frame.size.xy);
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= tiles.x * tiles.y) return;
    uvec2 count = uvec2(0u);
    for (uint i = 0u; i < TILE * TILE; ++i) {
        uvec2 pixel = tile_pixel(tile, i, frame.size.xy);
        if (any(greaterThanEqual(pixel, frame.size.xy))) continue;
        uint index = pixel.y * frame.size.x + pixel.x;
        if (states[index] == UNCERTAIN) ++count.x;
        if (receivers[index].map.w == 1.0) ++count.y;
    }
    counts[tile] = count;
}
