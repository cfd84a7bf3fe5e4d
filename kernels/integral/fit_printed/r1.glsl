// The slope r1 of the lobe's linear fit over half the interval (a, b), as printed: the difference of two nearly equal
// terms over (λq)².   [Appendix A, Equation 1]
#include "integral/fit_printed/lobe.glslh"

float printed_r1(PrintedLobe lobe, float lambda) {
    precise float difference = lambda * lobe.q * lobe.cosh - lobe.sinh;
    return 3.0 * lobe.c * difference / (lambda * lambda * lobe.q * lobe.q);
}

float integral_fit_printed_r1(vec2 ends, float lambda, float mu) {
    return printed_r1(printed_lobe(ends, lambda, mu), lambda);
}
