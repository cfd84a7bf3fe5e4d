// The constant α of the lobe's linear fit α + βx on (a, b), as printed.   [Appendix A, Equation 2]
#include "integral/fit_printed/r0.glsl"
#include "integral/fit_printed/r1.glsl"

float integral_fit_printed_alpha(vec2 ends, float lambda, float mu) {
    float r1 = integral_fit_printed_r1(ends, lambda, mu);
    return integral_fit_printed_r0(ends, lambda, mu) - r1 * (ends.x + ends.y) / (ends.y - ends.x);
}
