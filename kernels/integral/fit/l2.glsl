// How far the lobe's linear fit is from the lobe: the root of the integral of (G - L)² over the interval of x.
// [Appendix A, Equation 3 read as the L2 norm; docs/integrals.md, section 4]
// An interval that ends before it begins is turned round. Inputs that are not finite: 0.
#include "integral/fit/lobe.glslh"

float integral_fit_l2(vec2 versines, float lambda, float mu) {
    if (!is_answered(versines, lambda, mu)) return 0.0;
    Lobe lobe = lobe_on(versines, lambda, mu);
    float m = lobe.m, z = m * m;
    // By powers of m²: f_j = 2^(2j+1)/(2j+1)! - 4·2^(2j+2)/(2j+2)! + 6·2^(2j+3)/(2j+3)! - 3·2^(2j+4)/(2j+4)!, j = 2 … 12.
    // None is negative, so nothing cancels; at m = 3 the first left out is 2e-9 of the sum.
    float series =
        4.44444444e-2 +
        z * (7.61904762e-3 +
             z * (5.64373898e-4 +
                  z * (2.44317705e-5 +
                       z * (7.0476261e-7 +
                            z * (1.46172986e-8 +
                                 z * (2.29290958e-10 +
                                      z * (2.82107809e-12 +
                                           z * (2.79868858e-14 +
                                                z * (2.28803972e-16 + z * 1.56894152e-18)))))))));
    float low = abs(lobe.peak) * exponential(-m) * z * sqrt(lobe.q * series);
    float r = 1.0 / m, e2 = exponential(-2.0 * m), e4 = exponential(-4.0 * m);
    precise float squared =
        r * (0.5 * (1.0 - e4) - r * (2.0 * (1.0 + e4) - r * (3.0 * (1.0 - e4) - r * (1.5 * (1.0 + e4)))) -
             r * (2.0 - 3.0 * r * r) * e2);
    float high = abs(lobe.peak) * sqrt(lobe.q * max(squared, 0.0));
    return bounded(m <= 3.0 ? low : high);
}
