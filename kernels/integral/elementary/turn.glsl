// The point of the unit circle at the angle x: (cos x, sin x), the same bits on every device.   [Taylor, Cody and Waite]
#include "integral/elementary/reduce.glslh"

vec2 integral_elementary_turn(float x) {
    Quarter q = reduce(x);
    float c = cosine_near_0(q.rest), s = sine_near_0(q.rest);
    vec2 turned = (q.quadrant & 1u) == 0u ? vec2(c, s) : vec2(-s, c);
    return (q.quadrant & 2u) == 0u ? turned : -turned;
}
