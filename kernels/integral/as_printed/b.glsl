// The integral of (p·ω)(n·ω) sinθ over φ0 … φ1 and θ0 … kφ + b, exactly as printed: B0 is never a number.   [Appendix B,
// Equation 11]
#include "integral/as_printed/b0.glsl"
#include "integral/printed/b1.glsl"
#include "integral/printed/b2.glsl"
#include "integral/printed/b3.glsl"

float integral_as_printed_b(float phi0, float phi1, float theta0, float k, float b, vec3 n, vec3 p) {
    // x first: (p_x cosφ + p_y sinφ) = u sin(φ + γ).
    float u_p = length(p.xy), gamma = atan(p.x, p.y), u_n = length(n.xy), tau = atan(n.x, n.y);
    return u_p * u_n * integral_as_printed_b0(phi0, phi1, theta0, k, b, gamma, tau) +
           u_p * n.z * integral_printed_b1(phi0, phi1, theta0, k, b, gamma) +
           p.z * u_n * integral_printed_b2(phi0, phi1, theta0, k, b, tau) +
           p.z * n.z * integral_printed_b3(phi0, phi1, theta0, k, b);
}
