// The slope β of the lobe's linear fit α + βx on (a, b), as printed.   [Appendix A, Equation 2]
#include "integral/fit_printed/r1.glsl"

float printed_beta(vec2 ends, float r1) { return 2.0 * r1 / (ends.y - ends.x); }

float integral_fit_printed_beta(vec2 ends, float lambda, float mu) {
    return printed_beta(ends, printed_r1(printed_lobe(ends, lambda, mu), lambda));
}
