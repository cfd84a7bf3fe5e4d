// The integral of (p·ω)(n·ω) sinθ over φ0 … φ1 and θ0 … kφ + b.   [Appendix B, Equation 11]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/b0.glsl"
#include "integral/sinc/b1.glsl"
#include "integral/sinc/b2.glsl"
#include "integral/sinc/b3.glsl"

float integral_sinc_b(float phi0, float phi1, float theta0, float k, float b, vec3 n, vec3 p) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)) && is_finite(n) && is_finite(p))) return 0.0;
    // x first: (p_x cosφ + p_y sinφ) = u sin(φ + γ).
    float u_p = length(p.xy), gamma = atan(p.x, p.y), u_n = length(n.xy), tau = atan(n.x, n.y);
    return bounded(u_p * u_n * integral_sinc_b0(phi0, phi1, theta0, k, b, gamma, tau) +
                   u_p * n.z * integral_sinc_b1(phi0, phi1, theta0, k, b, gamma) +
                   p.z * u_n * integral_sinc_b2(phi0, phi1, theta0, k, b, tau) +
                   p.z * n.z * integral_sinc_b3(phi0, phi1, theta0, k, b));
}
