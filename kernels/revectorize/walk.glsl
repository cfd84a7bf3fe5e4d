// Texels to the end of the run in direction `heading`: +k if the shadow test flips at the k-th texel (the edge's end), -k if
// that texel no longer shares a side with the start (the edge's beginning), -17 if 16 texels decide nothing.
// Sides are shared on the axis across the walk only: "any side at all" would break the symmetry of x and y.
// [docs/revectorization.md 1.1; Optimized RBSM 2017, listing 3]
#include "revectorize/lit.glslh"
#include "revectorize/sides.glslh"

const int LONGEST_WALK = 16; // keeps an edge stable while the light moves; runs beyond fade   [Optimized RBSM 2017, 3.1.3]

int revectorize_walk(ivec2 texel, uvec2 sides, ivec2 heading) {
    bool start = lit(texel);
    ivec2 across = abs(heading.yx);
    uint wanted = heading.x != 0 ? sides.y : sides.x;
    for (int k = 1; k <= LONGEST_WALK; ++k) {
        ivec2 reached = texel + k * heading;
        if (lit(reached) != start) return k;
        bool shares = ((wanted & MINUS) != 0u && lit(reached - across) != start) ||
                      ((wanted & PLUS) != 0u && lit(reached + across) != start);
        if (!shares) return -k;
    }
    return -(LONGEST_WALK + 1);
}
