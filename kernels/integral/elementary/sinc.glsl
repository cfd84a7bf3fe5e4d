// S(x) = sin x / x, 1 at 0: the mean of cos over -x … x.   [docs/integrals.md, section 3]
#include "integral/trigonometry.glslh"

float integral_elementary_sinc(float x) {
    float mean = sine(x) / x; // named first, or glslang makes a branch of it
    return abs(x) > 0.0 ? mean : 1.0; // NaN is taken for 0, as sin takes it
}
