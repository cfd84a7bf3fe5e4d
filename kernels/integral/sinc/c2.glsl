// The integral of cos(sφ + t) over φ0 … φ1.   [Appendix B, Equation 7, C2; docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

float integral_sinc_c2(float phi0, float phi1, float s, float t) {
    if (!(is_finite(vec2(phi0, phi1)) && is_finite(vec2(s, t)))) return 0.0;
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    return bounded(wave_of_cos(m, h, s, t));
}
