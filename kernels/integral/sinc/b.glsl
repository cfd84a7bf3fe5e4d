// The integral of (p·ω)(n·ω) sinθ over φ0 … φ1 and θ0 … kφ + b.   [Appendix B, Equation 11]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/b0.glsl"
#include "integral/sinc/b1.glsl"
#include "integral/sinc/b3.glsl"

float sinc_b(float phi0, float phi1, float theta0, float k, float b, vec3 n, vec3 p) {
    float u_p = length(p.xy), gamma = phase_of(p.xy), u_n = length(n.xy), tau = phase_of(n.xy);
    // B1 is asked for p's wave in φ, weighed by n_z, and B2 for n's, weighed by p_z. They are the same integral
    // otherwise, and the sum of two waves is one.
    precise vec2 both = n.z * p.xy + p.z * n.xy;
    return u_p * u_n * sinc_b0(phi0, phi1, theta0, k, b, gamma, tau) +
           length(both) * sinc_b1(phi0, phi1, theta0, k, b, phase_of(both)) +
           p.z * n.z * sinc_b3(phi0, phi1, theta0, k, b);
}

float integral_sinc_b(float phi0, float phi1, float theta0, float k, float b, vec3 n, vec3 p) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)) && is_finite(n) && is_finite(p))) return 0.0;
    return bounded(sinc_b(phi0, phi1, theta0, k, b, n, p));
}
