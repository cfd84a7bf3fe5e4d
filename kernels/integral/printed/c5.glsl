// The integral of sin(φ + p) sin(φ + q) cos(sφ + t) over φ0 … φ1, as printed: divides by s, s - 2 and s + 2.
// [Appendix B, Equation 7, C5]
#include "integral/trigonometry.glslh"

float c5_antiderivative(float phi, float p, float q, float s, float t, float still) {
    return sine(s * phi + t) * still / (2.0 * s) - sine((s - 2.0) * phi + t - p - q) / (4.0 * (s - 2.0)) -
           sine((s + 2.0) * phi + t + p + q) / (4.0 * (s + 2.0));
}

float integral_printed_c5(float phi0, float phi1, float p, float q, float s, float t) {
    float still = cosine(p - q); // the part of sin(φ + p) sin(φ + q) that does not turn
    return c5_antiderivative(phi1, p, q, s, t, still) - c5_antiderivative(phi0, p, q, s, t, still);
}
