// The integral of cos²θ sinθ over φ0 … φ1 and θ0 … kφ + b, by its mean values.   [Appendix B, Equation 15, B3;
// docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

float sinc_b3(float phi0, float phi1, float theta0, float k, float b) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    // cos³θ0 - cos³θ1 in the middle, its first factor as a product of sines, and what the slope adds to its mean.
    float middle = k * m + b, c0 = cosine(theta0), cm = cosine(middle);
    float drop = 2.0 * sine(0.5 * (middle + theta0)) * sine(0.5 * (middle - theta0));
    precise float sum = 2.0 * drop * (cm * cm + cm * c0 + c0 * c0) +
                        0.5 * (integral_elementary_sinc_deficit(3.0 * k * h) * cosine(3.0 * middle) +
                               3.0 * integral_elementary_sinc_deficit(k * h) * cm);
    return h * sum / 3.0;
}

float integral_sinc_b3(float phi0, float phi1, float theta0, float k, float b) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)))) return 0.0;
    return bounded(sinc_b3(phi0, phi1, theta0, k, b));
}
