// The integral of sin(φ + p) sin(sφ + t) over φ0 … φ1: two waves, the product's difference and sum.
// [Appendix B, Equation 7, C4; docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

float sinc_c4(float phi0, float phi1, float p, float s, float t) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    return 0.5 * (wave_of_cos(m, h, 1.0 - s, p - t) - wave_of_cos(m, h, 1.0 + s, p + t));
}

float integral_sinc_c4(float phi0, float phi1, float p, float s, float t) {
    if (!(is_finite(vec3(phi0, phi1, p)) && is_finite(vec2(s, t)))) return 0.0;
    return bounded(sinc_c4(phi0, phi1, p, s, t));
}
