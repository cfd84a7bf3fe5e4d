// Where a slot or bar one texel wide first loses a wall: the sides left at the nearest texel along it that has not both,
// d_cb. A slot that is closed on one end is followed away from it only, any other both ways in step; where the shadow test
// flips, that way ends. Of two equally near breaches one without walls wins, and different walls make BOTH.
// UNBROKEN if 16 texels hold none.   [RBSM supplement, 3; docs/revectorization.md 1.6; docs/decisions.md, A5]
#include "revectorize/breach.glslh"
#include "revectorize/discontinuity.glsl"
#include "revectorize/walk.glsl"

uint revectorize_breach(ivec2 texel, uvec2 sides) {
    bool along_y = sides.x == BOTH;
    bool start = lit(texel);
    uint closed = along_y ? sides.y : sides.x;
    bvec2 open = bvec2((closed & MINUS) == 0u, (closed & PLUS) == 0u); // ways still followed, towards - and +
    for (int k = 1; k <= LONGEST_WALK; ++k) {
        uint found = UNBROKEN;
        for (int way = 0; way < 2; ++way) {
            if (!open[way]) continue;
            int steps = way == 0 ? -k : k;
            ivec2 reached = texel + (along_y ? ivec2(0, steps) : ivec2(steps, 0));
            if (lit(reached) != start) {
                open[way] = false;
                continue;
            }
            uvec2 there = revectorize_discontinuity(reached);
            uint walls = along_y ? there.x : there.y;
            if (walls == BOTH) continue;
            if (found == UNBROKEN) found = walls;
            else found = found == NEITHER || walls == NEITHER ? NEITHER : found | walls;
        }
        if (found != UNBROKEN) return found;
        if (!any(open)) break;
    }
    return UNBROKEN;
}
