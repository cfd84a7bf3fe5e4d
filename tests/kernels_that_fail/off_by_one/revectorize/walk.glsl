// Counts the first step as none.
#include "revectorize/lit.glslh"
#include "revectorize/sides.glslh"

int revectorize_walk(ivec2 texel, uvec2 sides, ivec2 heading) {
    bool start = lit(texel);
    ivec2 across = abs(heading.yx);
    uint wanted = heading.x != 0 ? sides.y : sides.x;
    for (int k = 1; k <= 16; ++k) {
        ivec2 reached = texel + k * heading;
        if (lit(reached) != start) return k - 1;
        bool shares = ((wanted & MINUS) != 0u && lit(reached - across) != start) ||
                      ((wanted & PLUS) != 0u && lit(reached + across) != start);
        if (!shares) return 1 - k;
    }
    return -17;
}
