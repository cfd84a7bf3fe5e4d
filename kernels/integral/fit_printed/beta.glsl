// The slope β of the lobe's linear fit α + βx on (a, b), as printed.   [Appendix A, Equation 2]
#include "integral/fit_printed/r1.glsl"

float integral_fit_printed_beta(vec2 ends, float lambda, float mu) {
    return 2.0 * integral_fit_printed_r1(ends, lambda, mu) / (ends.y - ends.x);
}
