// The integral of sin(φ + γ) sin(φ + τ) sin³θ over φ0 … φ1 and θ0 … kφ + b, of waves without a division.   [Appendix B,
// Equation 12, B0]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/c5.glsl"

float sinc_b0(float phi0, float phi1, float theta0, float k, float b, float gamma, float tau) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    // sin(φ + γ) sin(φ + τ): C4 with s = 1, of which one wave does not turn.
    float of_sines = h * cosine(gamma - tau) - 0.5 * wave_of_cos(m, h, 2.0, gamma + tau);
    float c = cosine(theta0); // cos 3θ - 9 cosθ is 4 cosθ (cos²θ - 3)
    return (sinc_c5(phi0, phi1, gamma, tau, 3.0 * k, 3.0 * b) - 9.0 * sinc_c5(phi0, phi1, gamma, tau, k, b) -
            4.0 * c * (c * c - 3.0) * of_sines) /
           12.0;
}

float integral_sinc_b0(float phi0, float phi1, float theta0, float k, float b, float gamma, float tau) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)) && is_finite(vec2(gamma, tau)))) return 0.0;
    return bounded(sinc_b0(phi0, phi1, theta0, k, b, gamma, tau));
}
