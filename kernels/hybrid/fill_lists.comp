// The queue of large triangles: one bin of one of them per thread.
#include "hybrid/lists.glslh"
#include "pipeline/linear.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 10) readonly buffer Pairs { uvec2 pairs[]; };

void main() {
    uint pair = linear_index();
    if (pair >= min(pair_count, space.size.w)) return;
    uint triangle = pairs[pair].x;
    ivec2 bin = ivec2(pairs[pair].y % space.bins.y, pairs[pair].y / space.bins.y) * bin_side();
    Solid t = solid(triangle);
    ivec2 from, to;
    box_of(t, from, to);
    put(triangle, t, max(from, bin), min(to, bin + bin_side() - 1));
}
