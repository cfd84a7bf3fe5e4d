// The integral of sin(φ + γ) sin(φ + τ) sin³θ over φ0 … φ1 and θ0 … kφ + b, of waves without a division.   [Appendix B,
// Equation 12, B0]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/c4.glsl"
#include "integral/sinc/c5.glsl"

float integral_sinc_b0(float phi0, float phi1, float theta0, float k, float b, float gamma, float tau) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)) && is_finite(vec2(gamma, tau)))) return 0.0;
    return bounded((integral_sinc_c5(phi0, phi1, gamma, tau, 3.0 * k, 3.0 * b) -
                    9.0 * integral_sinc_c5(phi0, phi1, gamma, tau, k, b) -
                    (cosine(3.0 * theta0) - 9.0 * cosine(theta0)) * integral_sinc_c4(phi0, phi1, gamma, 1.0, tau)) /
                   12.0);
}
