// How far the lobe's linear fit is from the lobe: the integral of |G - L| over the interval of x. The lobe is convex, so
// the line crosses it twice, at t1 and t2 of -1 … 1, and G - L integrates to 0 over the whole: with W an antiderivative
// the sum of the three parts is 2 (W(t1) - W(t2)). W is flat where the line crosses, so a crossing known to 1e-4 is
// known well enough.   [Appendix A, Equation 3 read as the L1 norm]
// An interval that ends before it begins is turned round. Inputs that are not finite: 0.
#include "integral/fit/r0.glsl"

// G - L = Σ (2n+1) i_n(m) P_n(t) over n >= 2, with i_n the modified spherical Bessel functions, whose ratios
// i_n / i_(n-1) = m / (2n+1 + m i_(n+1)/i_n) need no powers of m. In units of 5 i_2: (value, slope).
const int HARMONICS = 11; // at m = 3 those left out are 1e-9 of the whole
vec2 remainder_at(float ratio[HARMONICS + 1], float t) {
    float before = t, here = 1.5 * t * t - 0.5;     // P_1, P_2
    float slope_before = 1.0, slope_here = 3.0 * t; // their derivatives
    float weight = 1.0;
    vec2 sum = vec2(0.0);
    for (int n = 2; n <= HARMONICS; ++n) {
        if (n > 2) weight *= ratio[n];
        float height = weight * float(2 * n + 1) / 5.0;
        sum += height * vec2(here, slope_here);
        float next = (float(2 * n + 1) * t * here - float(n) * before) / float(n + 1);
        float slope_next = slope_before + float(2 * n + 1) * here;
        before = here, here = next;
        slope_before = slope_here, slope_here = slope_next;
    }
    return sum;
}

// Σ i_n (P_(n+1) - P_(n-1)) in units of i_2: the antiderivative that is 0 at both ends.
float antiderivative_at(float ratio[HARMONICS + 1], float t) {
    float before = t, here = 1.5 * t * t - 0.5, weight = 1.0, sum = 0.0;
    for (int n = 2; n <= HARMONICS; ++n) {
        if (n > 2) weight *= ratio[n];
        float next = (float(2 * n + 1) * t * here - float(n) * before) / float(n + 1);
        sum += weight * (next - before);
        before = here, here = next;
    }
    return sum;
}

float l1_by_harmonics(float m) { // per r0 and half width
    float ratio[HARMONICS + 1];
    float next = 0.0;
    for (int n = HARMONICS; n >= 1; --n) {
        next = m / (float(2 * n + 1) + m * next);
        ratio[n] = next;
    }
    // Newton from outside: the difference is convex, so that no step goes too far. At m = 3, where it goes farthest, four
    // leave 3e-11 of the whole.
    float t1 = -1.0, t2 = 1.0;
    for (int i = 0; i < 4; ++i) {
        vec2 at1 = remainder_at(ratio, t1), at2 = remainder_at(ratio, t2);
        t1 -= at1.x / at1.y;
        t2 -= at2.x / at2.y;
    }
    return 2.0 * ratio[1] * ratio[2] * (antiderivative_at(ratio, t1) - antiderivative_at(ratio, t2));
}

float l1_by_antiderivative(float m) { // per upper end's height and half width
    float r = 1.0 / m, e = exponential(-2.0 * m);
    float line = 0.5 * r * (1.0 - e), slope = 1.5 * r * ((1.0 - r) + (1.0 + r) * e); // L = line + slope t
    // At m = 3 two steps leave 5e-9 of the whole; three of those below 1e-13.
    float t1 = -1.0;
    for (int i = 0; i < 2; ++i) {
        float power = exponential(m * (t1 - 1.0));
        t1 -= (power - line - slope * t1) / (m * power - slope);
    }
    // Near the upper end the lobe changes over 1/m: there, in s = m (1 - t), beginning on the far side of the crossing.
    float s = -log(max(line + slope, 1e-37));
    for (int i = 0; i < 3; ++i) {
        float power = exponential(-s);
        s -= (power - (line + slope) + slope * s * r) / (slope * r - power);
    }
    float t2 = 1.0 - s * r;
    precise float under_line = line * (t2 - t1) + 0.5 * slope * (t2 - t1) * (t2 + t1);
    return 2.0 * (under_line - r * (exponential(-s) - exponential(m * (t1 - 1.0))));
}

float integral_fit_l1(vec2 versines, float lambda, float mu) {
    if (!is_answered(versines, lambda, mu)) return 0.0;
    Lobe lobe = lobe_on(versines, lambda, mu);
    if (lobe.m == 0.0) return 0.0;
    float low = lobe.q * abs(fit_r0(lobe)) * l1_by_harmonics(min(lobe.m, 3.0));
    float high = lobe.q * abs(lobe.peak) * l1_by_antiderivative(max(lobe.m, 3.0));
    return bounded(lobe.m <= 3.0 ? low : high);
}
