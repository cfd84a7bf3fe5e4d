// Where the receivers are, the pixels that face the light: in the map, which a map fitted to the visible points covers, and in the
// world, near which float32 coordinates are finest.
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"
#include "hybrid/tile.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 2) writeonly buffer Bounds { vec4 bounds[]; }; // per tile: texels, least and greatest; world, least; greatest

void main() {
    uvec2 tiles = tile_count(frame.size.xy);
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= tiles.x * tiles.y) return;
    vec2 lower = vec2(1e30), upper = vec2(-1e30); // the wrong way round: none
    vec3 least = vec3(1e30), greatest = vec3(-1e30);
    for (uint i = 0u; i < TILE * TILE; ++i) {
        uvec2 pixel = tile_pixel(tile, i, frame.size.xy);
        if (any(greaterThanEqual(pixel, frame.size.xy))) continue;
        uint index = pixel.y * frame.size.x + pixel.x;
        vec4 map = receivers[index].map;
        if (map.w != 1.0) continue;
        lower = min(lower, map.xy);
        upper = max(upper, map.xy);
        vec3 origin = receivers[index].origin.xyz;
        least = min(least, origin);
        greatest = max(greatest, origin);
    }
    bounds[3u * tile] = vec4(lower, upper);
    bounds[3u * tile + 1u] = vec4(least, 0.0);
    bounds[3u * tile + 2u] = vec4(greatest, 0.0);
}
