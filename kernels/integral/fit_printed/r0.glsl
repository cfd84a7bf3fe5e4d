// The mean of the lobe μ e^(λ(x-1)) over the interval (a, b), as printed: divides by λq.   [Appendix A, Equation 1]
#include "integral/fit_printed/lobe.glslh"

float printed_r0(PrintedLobe lobe, float lambda) { return lobe.c * lobe.sinh / (lambda * lobe.q); }

float integral_fit_printed_r0(vec2 ends, float lambda, float mu) {
    return printed_r0(printed_lobe(ends, lambda, mu), lambda);
}
