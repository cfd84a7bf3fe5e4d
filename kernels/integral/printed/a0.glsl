// The integral of sin(φ + τ) sin²θ over φ0 … φ1 and θ0 … kφ + b, as printed.   [Appendix B, Equation 9, A0]
#include "integral/printed/c1.glsl"
#include "integral/printed/c3.glsl"
#include "integral/printed/c4.glsl"
#include "integral/trigonometry.glslh"

float integral_printed_a0(float phi0, float phi1, float theta0, float k, float b, float tau) {
    return 0.25 * (2.0 * k * integral_printed_c3(phi0, phi1, tau) - integral_printed_c4(phi0, phi1, tau, 2.0 * k, 2.0 * b) +
                   (2.0 * b - 2.0 * theta0 + sine(2.0 * theta0)) * integral_printed_c1(phi0, phi1, tau));
}
