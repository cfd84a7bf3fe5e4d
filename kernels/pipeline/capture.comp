// What a pixel's kernel saw: its texel, its position in it, and `lit` over the window that any walk can reach, one bit per
// texel. With it a pixel can be run again alone.
#include "pipeline/shadow_map.glslh"

const int RADIUS = 18;
const int SIDE = 2 * RADIUS + 1;
const uint WORDS = uint(SIDE * SIDE + 31) / 32u;

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Pixels { uint pixels[]; };
layout(std430, binding = 4) writeonly buffer Captures { uint captures[]; };
layout(push_constant) uniform Constants { uint count; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    receiver = receivers[pixels[index]];
    ivec2 centre = receiver_texel();
    vec2 p = receiver_p();
    uint base = index * (4u + WORDS);
    captures[base] = uint(centre.x);
    captures[base + 1u] = uint(centre.y);
    captures[base + 2u] = floatBitsToUint(p.x);
    captures[base + 3u] = floatBitsToUint(p.y);
    for (uint word = 0u; word < WORDS; ++word) {
        uint bits = 0u;
        for (uint k = 0u; k < 32u; ++k) {
            int n = int(32u * word + k);
            if (n < SIDE * SIDE && lit(centre + ivec2(n % SIDE - RADIUS, n / SIDE - RADIUS))) bits |= 1u << k;
        }
        captures[base + 4u + word] = bits;
    }
}
