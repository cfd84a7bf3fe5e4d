// The integral of sin(φ + p) over φ0 … φ1.   [Appendix B, Equation 7, C1; docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

float sinc_c1(float phi0, float phi1, float p) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    return wave_of_sin(m, h, 1.0, p);
}

float integral_sinc_c1(float phi0, float phi1, float p) {
    if (!is_finite(vec3(phi0, phi1, p))) return 0.0;
    return bounded(sinc_c1(phi0, phi1, p));
}
