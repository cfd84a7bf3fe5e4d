// The integral of sin(φ + τ) sin²θ over φ0 … φ1 and θ0 … kφ + b, of waves without a division.   [Appendix B, Equation 9,
// A0]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/c1.glsl"
#include "integral/sinc/c4.glsl"

float sinc_a0(float phi0, float phi1, float theta0, float k, float b, float tau) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    // C3 is m C1 and a part that is odd about m. m may be many turns, and b takes off what k m puts on: together they are
    // how far the boundary lies from θ0 in the middle.
    precise float rise = k * m + b - theta0;
    return 0.25 * (4.0 * k * cosine(m + tau) * half_moment_of_sine(h) - sinc_c4(phi0, phi1, tau, 2.0 * k, 2.0 * b) +
                   (2.0 * rise + sine(2.0 * theta0)) * sinc_c1(phi0, phi1, tau));
}

float integral_sinc_a0(float phi0, float phi1, float theta0, float k, float b, float tau) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec3(k, b, tau)))) return 0.0;
    return bounded(sinc_a0(phi0, phi1, theta0, k, b, tau));
}
