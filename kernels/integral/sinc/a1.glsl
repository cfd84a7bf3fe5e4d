// The integral of cosθ sinθ over φ0 … φ1 and θ0 … kφ + b, by its mean values.   [Appendix B, Equation 10, A1;
// docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

float sinc_a1(float phi0, float phi1, float theta0, float k, float b) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    // sin²θ1 - sin²θ0 in the middle as a product of sines, and what the boundary's slope adds to its mean.
    float middle = k * m + b;
    precise float sum = 2.0 * sine(middle + theta0) * sine(middle - theta0) +
                        integral_elementary_sinc_deficit(2.0 * k * h) * cosine(2.0 * middle);
    return 0.5 * h * sum;
}

float integral_sinc_a1(float phi0, float phi1, float theta0, float k, float b) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)))) return 0.0;
    return bounded(sinc_a1(phi0, phi1, theta0, k, b));
}
