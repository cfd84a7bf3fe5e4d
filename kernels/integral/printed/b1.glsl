// The integral of sin(φ + γ) cosθ sin²θ over φ0 … φ1 and θ0 … kφ + b, as printed.   [Appendix B, Equation 13, B1]
#include "integral/printed/c1.glsl"
#include "integral/printed/c4.glsl"
#include "integral/trigonometry.glslh"

float integral_printed_b1(float phi0, float phi1, float theta0, float k, float b, float gamma) {
    return (3.0 * integral_printed_c4(phi0, phi1, gamma, k, b) - integral_printed_c4(phi0, phi1, gamma, 3.0 * k, 3.0 * b) -
            (3.0 * sine(theta0) - sine(3.0 * theta0)) * integral_printed_c1(phi0, phi1, gamma)) /
           12.0;
}
