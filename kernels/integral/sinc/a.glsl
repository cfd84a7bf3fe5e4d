// The integral of (n·ω) sinθ over φ0 … φ1 and θ0 … kφ + b.   [Appendix B, Equation 8]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/a0.glsl"
#include "integral/sinc/a1.glsl"

float sinc_a(float phi0, float phi1, float theta0, float k, float b, vec3 n) {
    float u = length(n.xy), tau = phase_of(n.xy);
    return u * sinc_a0(phi0, phi1, theta0, k, b, tau) + n.z * sinc_a1(phi0, phi1, theta0, k, b);
}

float integral_sinc_a(float phi0, float phi1, float theta0, float k, float b, vec3 n) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)) && is_finite(n))) return 0.0;
    return bounded(sinc_a(phi0, phi1, theta0, k, b, n));
}
