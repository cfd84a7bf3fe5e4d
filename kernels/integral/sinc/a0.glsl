// The integral of sin(φ + τ) sin²θ over φ0 … φ1 and θ0 … kφ + b, of waves without a division.   [Appendix B, Equation 9,
// A0]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/c1.glsl"
#include "integral/sinc/c3.glsl"
#include "integral/sinc/c4.glsl"

float sinc_a0(float phi0, float phi1, float theta0, float k, float b, float tau) {
    return 0.25 * (2.0 * k * sinc_c3(phi0, phi1, tau) - sinc_c4(phi0, phi1, tau, 2.0 * k, 2.0 * b) +
                   (2.0 * b - 2.0 * theta0 + sine(2.0 * theta0)) * sinc_c1(phi0, phi1, tau));
}

float integral_sinc_a0(float phi0, float phi1, float theta0, float k, float b, float tau) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec3(k, b, tau)))) return 0.0;
    return bounded(sinc_a0(phi0, phi1, theta0, k, b, tau));
}
