// The integral of sin(φ + p) sin(φ + q) cos(sφ + t) over φ0 … φ1: three waves.
// [Appendix B, Equation 7, C5; docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

float sinc_c5(float phi0, float phi1, float p, float q, float s, float t) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    return 0.5 * (cosine(p - q) * wave_of_cos(m, h, s, t) - 0.5 * wave_of_cos(m, h, s - 2.0, t - p - q) -
                  0.5 * wave_of_cos(m, h, s + 2.0, t + p + q));
}

float integral_sinc_c5(float phi0, float phi1, float p, float q, float s, float t) {
    if (!(is_finite(vec3(phi0, phi1, p)) && is_finite(vec3(q, s, t)))) return 0.0;
    return bounded(sinc_c5(phi0, phi1, p, q, s, t));
}
