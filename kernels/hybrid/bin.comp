// Every triangle: a small one goes into its texels' lists at once, a large one into a queue, once for each bin of receivers that it
// meets, so that no thread walks a whole map.
#include "hybrid/lists.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 8) writeonly buffer Pairs { uvec2 pairs[]; };  // triangle, bin

void main() {
    uint triangle = gl_GlobalInvocationID.x;
    if (triangle >= space.size.y) return;
    vec3 a = place(triangle, 0u), b = place(triangle, 1u), c = place(triangle, 2u);
    ivec2 from, to;
    box_of(a, b, c, from, to);
    if (any(greaterThan(from, to))) return;
    ivec2 first = from / BIN, last = to / BIN;
    bool small = all(lessThanEqual(last - first, ivec2(1)));
    float nearest = min(min(a.z, b.z), c.z) - space.margin.y;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            uint bin = uint(y) * bins_across() + uint(x);
            uint depth = bin_farthest[bin];
            if (depth == 0u || nearest > from_ordered(depth) - space.margin.z) continue;
            if (small) {
                put_all(triangle, a, b, c, max(from, ivec2(x, y) * BIN), min(to, ivec2(x, y) * BIN + BIN - 1));
                continue;
            }
            vec2 centre = (vec2(x, y) + 0.5) * float(BIN) - space.margin.w;
            if (!column_overlaps(a.xy, b.xy, c.xy, centre, 0.5 * float(BIN) + 2.0 * space.margin.x)) continue;
            uint pair = atomicAdd(pair_count, 1u);
            if (pair < space.size.w) pairs[pair] = uvec2(triangle, bin);
        }
}
