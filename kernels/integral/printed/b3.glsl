// The integral of cos²θ sinθ over φ0 … φ1 and θ0 … kφ + b, as printed.   [Appendix B, Equation 15, B3]
#include "integral/printed/c0.glsl"
#include "integral/printed/c2.glsl"
#include "integral/trigonometry.glslh"

float integral_printed_b3(float phi0, float phi1, float theta0, float k, float b) {
    return -(integral_printed_c2(phi0, phi1, 3.0 * k, 3.0 * b) + 3.0 * integral_printed_c2(phi0, phi1, k, b) -
             (cosine(3.0 * theta0) + 3.0 * cosine(theta0)) * integral_printed_c0(phi0, phi1)) /
           12.0;
}
