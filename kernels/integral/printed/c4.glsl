// The integral of sin(φ + p) sin(sφ + t) over φ0 … φ1, as printed but for s = 1, where the printed form divides by zero
// and its limit is taken: B0 asks for that on every input.   [Appendix B, Equation 7, C4; docs/integrals.md, section 1]
#include "integral/as_printed/c4.glsl"

float integral_printed_c4(float phi0, float phi1, float p, float s, float t) {
    float limit = 0.5 * ((phi1 - phi0) * cosine(p - t) - 0.5 * (sine(2.0 * phi1 + p + t) - sine(2.0 * phi0 + p + t)));
    float elsewhere = integral_as_printed_c4(phi0, phi1, p, s, t); // named first, or glslang makes a branch of it
    return s == 1.0 ? limit : elsewhere;
}
