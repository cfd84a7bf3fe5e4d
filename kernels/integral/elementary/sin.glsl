// sin x, the same bits on every device. Beyond |x| = 65536: 0.   [Taylor, Cody and Waite]
#include "integral/elementary/reduce.glslh"

float integral_elementary_sin(float x) {
    Quarter q = reduce(x);
    // Both, and one of them chosen: a branch costs more.
    float s = sine_near_0(q.rest), c = cosine_near_0(q.rest), value = (q.quadrant & 1u) == 0u ? s : c, opposite = -value;
    return (q.quadrant & 2u) == 0u ? value : opposite;
}
