// Where a slot or bar one texel wide first loses a wall: the sides left at the nearest texel along it that has not both,
// d_cb. A slot that is closed on one end is followed away from it only, any other both ways in step; where the shadow test
// flips, that way ends. Of two equally near breaches one without walls wins, and different walls make BOTH.
// UNBROKEN if 16 texels hold none.   [RBSM supplement, 3; docs/revectorization.md 1.6; docs/decisions.md, A5]
#include "revectorize/breach.glslh"
#include "revectorize/walk.glsl"
#include "revectorize/walls.glslh"

uint revectorize_breach(ivec2 texel, uvec2 sides) {
    ivec2 along = sides.x == BOTH ? ivec2(0, 1) : ivec2(1, 0);
    uint closed = sides.x == BOTH ? sides.y : sides.x;
    bool start = lit(texel);
    bool to_minus = (closed & MINUS) == 0u, to_plus = (closed & PLUS) == 0u; // ways still followed
    for (int k = 1; k <= LONGEST_WALK && (to_minus || to_plus); ++k) {
        ivec2 minus = texel - k * along, plus = texel + k * along;
        to_minus = to_minus && lit(minus) == start;
        to_plus = to_plus && lit(plus) == start;
        uint walls_minus = to_minus ? walls_of(minus, along.yx, start) : BOTH;
        uint walls_plus = to_plus ? walls_of(plus, along.yx, start) : BOTH;
        if (walls_minus == BOTH && walls_plus == BOTH) continue;
        if (walls_minus == BOTH) return walls_plus;
        if (walls_plus == BOTH) return walls_minus;
        return walls_minus == NEITHER || walls_plus == NEITHER ? NEITHER : walls_minus | walls_plus;
    }
    return UNBROKEN;
}
