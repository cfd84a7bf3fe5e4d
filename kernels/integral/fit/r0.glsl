// The mean of the lobe μ e^(λ(x-1)) over an interval of x, given by its versines (1 - a, 1 - b): the constant term r0 of
// its linear fit.   [Appendix A, Equation 1; docs/integrals.md, section 4]
// An interval that ends before it begins is turned round. Inputs that are not finite: 0.
#include "integral/elementary/exprel.glsl"
#include "integral/fit/lobe.glslh"

float fit_r0(Lobe lobe) { return lobe.peak * integral_elementary_exprel(2.0 * lobe.m); }

float integral_fit_r0(vec2 versines, float lambda, float mu) {
    if (!is_answered(versines, lambda, mu)) return 0.0;
    return bounded(fit_r0(lobe_on(versines, lambda, mu)));
}
