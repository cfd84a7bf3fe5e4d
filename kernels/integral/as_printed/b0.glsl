// The integral of sin(φ + γ) sin(φ + τ) sin³θ over φ0 … φ1 and θ0 … kφ + b, exactly as printed: C4 at s = 1 divides by
// zero, so that this is never a number.   [Appendix B, Equation 12, B0; docs/integrals.md, section 1]
#include "integral/as_printed/c4.glsl"
#include "integral/printed/c5.glsl"
#include "integral/trigonometry.glslh"

float integral_as_printed_b0(float phi0, float phi1, float theta0, float k, float b, float gamma, float tau) {
    return (integral_printed_c5(phi0, phi1, gamma, tau, 3.0 * k, 3.0 * b) -
            9.0 * integral_printed_c5(phi0, phi1, gamma, tau, k, b) -
            (cosine(3.0 * theta0) - 9.0 * cosine(theta0)) * integral_as_printed_c4(phi0, phi1, gamma, 1.0, tau)) /
           12.0;
}
