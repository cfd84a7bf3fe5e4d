// S(x) = sin x / x, 1 at 0: the mean of cos over -x … x.   [integrals.md, section 3]
#include "integral/trigonometry.glslh"

float integral_elementary_sinc(float x) {
    return x == 0.0 ? 1.0 : sine(x) / x;
}
