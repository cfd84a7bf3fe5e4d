// Every triangle: a small one goes into its texels' lists at once, a large one into a queue, once for each bin of receivers that it
// meets, so that no thread walks a whole map.
#include "hybrid/lists.glslh"
#include "pipeline/linear.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 10) writeonly buffer Pairs { uvec2 pairs[]; };  // triangle, bin

void main() {
    uint triangle = linear_index();
    if (triangle >= space.size.y) return;
    Solid t = solid(triangle);
    ivec2 from, to;
    box_of(t, from, to);
    if (any(greaterThan(from, to))) return;
    int side = bin_side();
    ivec2 first = from / side, last = to / side, texels = to - from + 1;
    bool small = all(lessThanEqual(last - first, ivec2(1))) && texels.x * texels.y <= 64;
    float nearest = min(min(t.p[0].z, t.p[1].z), t.p[2].z) - t.margin_z;
    int y = first.y, left = 0;
    for (; y <= last.y; ++y) {
        int x = first.x;
        for (; x <= last.x; ++x) {
            uint bin = bin_index(ivec2(x, y));
            if (bin_farthest[bin] == 0u || !can_be_hit(nearest, bin_farthest[bin])) continue;
            if (small) {
                put(triangle, t, max(from, ivec2(x, y) * side), min(to, ivec2(x, y) * side + side - 1));
                continue;
            }
            vec2 centre = (vec2(x, y) + 0.5) * float(side) + space.map.xy;
            if (!column_overlaps(t.p[0].xy, t.p[1].xy, t.p[2].xy, centre, 0.5 * float(side) + 2.0 * t.margin)) continue;
            uint pair = atomicAdd(pair_count, 1u);
            if (pair < space.size.w) pairs[pair] = uvec2(triangle, bin);
        }
        if (x <= last.x) ++left;
    }
    if (y <= last.y || left > 0) incomplete = 1u;
}
