// The constant α of the lobe's linear fit α + βx on (a, b), as printed.   [Appendix A, Equation 2]
#include "integral/fit_printed/r0.glsl"
#include "integral/fit_printed/r1.glsl"

float printed_alpha(vec2 ends, float r0, float r1) { return r0 - r1 * (ends.x + ends.y) / (ends.y - ends.x); }

float integral_fit_printed_alpha(vec2 ends, float lambda, float mu) {
    PrintedLobe lobe = printed_lobe(ends, lambda, mu);
    return printed_alpha(ends, printed_r0(lobe, lambda), printed_r1(lobe, lambda));
}
