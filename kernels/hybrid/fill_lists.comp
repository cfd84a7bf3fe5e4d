// The queue of large triangles: one bin of one of them per thread.
#include "hybrid/lists.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 8) readonly buffer Pairs { uvec2 pairs[]; };

void main() {
    uint pair = gl_GlobalInvocationID.x;
    if (pair >= min(pair_count, space.size.w)) return;
    uint triangle = pairs[pair].x;
    ivec2 bin = ivec2(pairs[pair].y % bins_across(), pairs[pair].y / bins_across());
    vec3 a = place(triangle, 0u), b = place(triangle, 1u), c = place(triangle, 2u);
    ivec2 from, to;
    box_of(a, b, c, from, to);
    put_all(triangle, a, b, c, max(from, bin * BIN), min(to, bin * BIN + BIN - 1));
}
