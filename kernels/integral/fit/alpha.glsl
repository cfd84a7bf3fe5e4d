// The constant α of the lobe's linear fit α + βx: r0 - β(a+b)/2, of which the difference leaves few digits if the lobe
// is sharp and the interval short. What is evaluated with it should be r0 + β(x - (a+b)/2) instead.
// [Appendix A, Equation 2; docs/integrals.md, section 4]
// An interval that ends before it begins is turned round. Inputs that are not finite: 0.
#include "integral/fit/beta.glsl"
#include "integral/fit/r0.glsl"

float fit_alpha(Lobe lobe, float beta, vec2 versines) {
    float middle = 1.0 - 0.5 * (versines.x + versines.y);
    precise float alpha = fit_r0(lobe) - beta * middle;
    return alpha;
}

float integral_fit_alpha(vec2 versines, float lambda, float mu) {
    if (!is_answered(versines, lambda, mu)) return 0.0;
    Lobe lobe = lobe_on(versines, lambda, mu);
    return bounded(fit_alpha(lobe, fit_beta(lobe, lambda), versines));
}
