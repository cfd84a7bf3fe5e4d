// The slope β of the lobe's linear fit α + βx: r1 over half the interval's width, without dividing by a width of 0.
// [Appendix A, Equation 2; docs/integrals.md, section 4]
// An interval that ends before it begins is turned round. Inputs that are not finite: 0.
#include "integral/fit/lobe.glslh"
#include "integral/fit/r1.glsl"

float fit_beta(Lobe lobe, float lambda) {
    float low = lobe.peak * exponential(-lobe.m) * lambda * slope_series(lobe.m), high = fit_r1(lobe) / lobe.q;
    return lobe.m <= 1.0 ? low : high;
}

float integral_fit_beta(vec2 versines, float lambda, float mu) {
    if (!is_answered(versines, lambda, mu)) return 0.0;
    return bounded(fit_beta(lobe_on(versines, lambda, mu), lambda));
}
