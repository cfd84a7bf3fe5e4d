// The integral of φ sin(φ + p) over φ0 … φ1: m C1 and what is odd about the middle m.
// [Appendix B, Equation 7, C3; docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

float integral_sinc_c3(float phi0, float phi1, float p) {
    if (!is_finite(vec3(phi0, phi1, p))) return 0.0;
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    precise float sum = m * wave_of_sin(m, h, 1.0, p) + 2.0 * cosine(m + p) * half_moment_of_sine(h);
    return bounded(sum);
}
