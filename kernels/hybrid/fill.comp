// The ray buffer: where each uncertain pixel's shadow ray starts, and whose it is.
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"
#include "hybrid/state.glslh"
#include "hybrid/tile.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 2) readonly buffer States { uint states[]; };
layout(std430, binding = 3) readonly buffer Counts { uvec2 starts[]; };
layout(std430, binding = 4) writeonly buffer Rays { vec4 rays[]; };   // xyz: origin
layout(std430, binding = 5) writeonly buffer Pixels { uint pixels[]; };

void main() {
    uvec2 tiles = tile_count(frame.size.xy);
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= tiles.x * tiles.y) return;
    uint ray = starts[tile].x;
    for (uint i = 0u; i < TILE * TILE; ++i) {
        uvec2 pixel = tile_pixel(tile, i, frame.size.xy);
        if (any(greaterThanEqual(pixel, frame.size.xy))) continue;
        uint index = pixel.y * frame.size.x + pixel.x;
        if (states[index] != UNCERTAIN) continue;
        rays[ray] = vec4(receivers[index].origin.xyz, 0.0);
        pixels[ray] = index;
        ++ray;
    }
}
