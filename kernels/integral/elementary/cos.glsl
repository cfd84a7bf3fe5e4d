// cos x, the same bits on every device. Beyond |x| = 65536: 1.   [Taylor, Cody and Waite]
#include "integral/elementary/reduce.glslh"

float integral_elementary_cos(float x) {
    Quarter q = reduce(x);
    float value = (q.quadrant & 1u) == 0u ? cosine_near_0(q.rest) : -sine_near_0(q.rest);
    return (q.quadrant & 2u) == 0u ? value : -value;
}
