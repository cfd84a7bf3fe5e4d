// The integral of sin(φ + τ) cosθ sin²θ over φ0 … φ1 and θ0 … kφ + b: B1 with the phase of n.   [Appendix B,
// Equation 14, B2]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/b1.glsl"

float integral_sinc_b2(float phi0, float phi1, float theta0, float k, float b, float tau) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec3(k, b, tau)))) return 0.0;
    return bounded(sinc_b1(phi0, phi1, theta0, k, b, tau));
}
