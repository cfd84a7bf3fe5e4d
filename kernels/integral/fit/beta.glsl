// The slope β of the lobe's linear fit α + βx: r1 over half the interval's width, without dividing by a width of 0.
// [Appendix A, Equation 2; docs/integrals.md, section 4]
// An interval that ends before it begins is turned round. Inputs that are not finite: 0.
#include "integral/fit/lobe.glslh"
#include "integral/fit/r1.glsl"

float integral_fit_beta(vec2 versines, float lambda, float mu) {
    if (!is_answered(versines, lambda, mu)) return 0.0;
    Lobe lobe = lobe_on(versines, lambda, mu);
    float low = lobe.peak * exponential(-lobe.m) * lambda * slope_series(lobe.m);
    return bounded(lobe.m <= 1.0 ? low : integral_fit_r1(versines, lambda, mu) / lobe.q);
}
