// The mean of the lobe μ e^(λ(x-1)) over the interval (a, b), as printed: divides by λq.   [Appendix A, Equation 1]
#include "integral/fit_printed/lobe.glslh"

float integral_fit_printed_r0(vec2 ends, float lambda, float mu) {
    float p = (ends.x + ends.y) / 2.0, q = (ends.y - ends.x) / 2.0;
    float c = mu * exponential(lambda * (p - 1.0));
    return c * hyperbolic_sine(lambda * q) / (lambda * q);
}
