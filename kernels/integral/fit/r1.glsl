// The slope r1 of the lobe's linear fit, over half the interval: r0 + r1 t for t = -1 … 1.
// [Appendix A, Equation 1; docs/integrals.md, section 4]
// An interval that ends before it begins is turned round. Inputs that are not finite: 0.
#include "integral/fit/lobe.glslh"

float fit_r1(Lobe lobe) {
    float m = lobe.m;
    float low = lobe.peak * exponential(-m) * m * slope_series(m);
    precise float high = 1.5 * lobe.peak / m * ((1.0 - 1.0 / m) + (1.0 + 1.0 / m) * exponential(-2.0 * m));
    return m <= 1.0 ? low : high;
}

float integral_fit_r1(vec2 versines, float lambda, float mu) {
    if (!is_answered(versines, lambda, mu)) return 0.0;
    return bounded(fit_r1(lobe_on(versines, lambda, mu)));
}
