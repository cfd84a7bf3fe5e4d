// The integral of sin(φ + τ) cosθ sin²θ over φ0 … φ1 and θ0 … kφ + b, of waves without a division.   [Appendix B,
// Equation 14, B2]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/c1.glsl"
#include "integral/sinc/c4.glsl"

float integral_sinc_b2(float phi0, float phi1, float theta0, float k, float b, float tau) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec3(k, b, tau)))) return 0.0;
    return bounded((3.0 * integral_sinc_c4(phi0, phi1, tau, k, b) - integral_sinc_c4(phi0, phi1, tau, 3.0 * k, 3.0 * b) -
                    (3.0 * sine(theta0) - sine(3.0 * theta0)) * integral_sinc_c1(phi0, phi1, tau)) /
                   12.0);
}
