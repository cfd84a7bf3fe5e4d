// The integral of (n·ω) sinθ over φ0 … φ1 and θ0 … kφ + b.   [Appendix B, Equation 8]
#include "integral/printed/a0.glsl"
#include "integral/printed/a1.glsl"

float integral_printed_a(float phi0, float phi1, float theta0, float k, float b, vec3 n) {
    // x first: (n_x cosφ + n_y sinφ) = u sin(φ + τ).
    float u = length(n.xy), tau = atan(n.x, n.y);
    return u * integral_printed_a0(phi0, phi1, theta0, k, b, tau) + n.z * integral_printed_a1(phi0, phi1, theta0, k, b);
}
