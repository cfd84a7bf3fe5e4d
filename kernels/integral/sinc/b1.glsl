// The integral of sin(φ + γ) cosθ sin²θ over φ0 … φ1 and θ0 … kφ + b, of waves without a division.   [Appendix B,
// Equation 13, B1]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/c1.glsl"
#include "integral/sinc/c4.glsl"

float sinc_b1(float phi0, float phi1, float theta0, float k, float b, float gamma) {
    float s = sine(theta0); // 3 sinθ - sin 3θ is 4 sin³θ
    return (3.0 * sinc_c4(phi0, phi1, gamma, k, b) - sinc_c4(phi0, phi1, gamma, 3.0 * k, 3.0 * b) -
            4.0 * s * s * s * sinc_c1(phi0, phi1, gamma)) /
           12.0;
}

float integral_sinc_b1(float phi0, float phi1, float theta0, float k, float b, float gamma) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec3(k, b, gamma)))) return 0.0;
    return bounded(sinc_b1(phi0, phi1, theta0, k, b, gamma));
}
