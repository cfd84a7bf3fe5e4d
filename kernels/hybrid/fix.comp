// What the rays found, put where their pixels are.
#include "pipeline/linear.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Pixels { uint pixels[]; };
layout(std430, binding = 1) readonly buffer Lit { uint lit_bytes[]; }; // four rays each: 1 reached the light
layout(std430, binding = 2) writeonly buffer Visibility { float visibility[]; };
layout(push_constant) uniform Constants { uint rays; };

void main() {
    uint ray = linear_index();
    if (ray >= rays) return;
    uint bits = lit_bytes[ray / 4u] >> (8u * (ray % 4u));
    visibility[pixels[ray]] = (bits & 1u) != 0u ? 1.0 : 0.0;
}
