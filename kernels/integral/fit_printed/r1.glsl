// The slope r1 of the lobe's linear fit over half the interval (a, b), as printed: the difference of two nearly equal
// terms over (λq)².   [Appendix A, Equation 1]
#include "integral/fit_printed/lobe.glslh"

float integral_fit_printed_r1(vec2 ends, float lambda, float mu) {
    float p = (ends.x + ends.y) / 2.0, q = (ends.y - ends.x) / 2.0;
    float c = mu * exponential(lambda * (p - 1.0));
    precise float difference = lambda * q * hyperbolic_cosine(lambda * q) - hyperbolic_sine(lambda * q);
    return 3.0 * c * difference / (lambda * lambda * q * q);
}
