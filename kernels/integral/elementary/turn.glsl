// The point of the unit circle at the angle x: (cos x, sin x), the same bits on every device.   [Taylor, Cody and Waite]
#include "integral/elementary/reduce.glslh"

vec2 integral_elementary_turn(float x) {
    float quarters = quarters_in(x), rest = rest_of(x, quarters);
    uint quadrant = quadrant_of(x, quarters);
    float c = cosine_near_0(rest), s = sine_near_0(rest);
    vec2 turned = (quadrant & 1u) == 0u ? vec2(c, s) : vec2(-s, c);
    return (quadrant & 2u) == 0u ? turned : -turned;
}
