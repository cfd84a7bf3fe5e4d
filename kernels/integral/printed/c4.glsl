// The integral of sin(φ + p) sin(sφ + t) over φ0 … φ1, as printed but for s = 1, where the printed form divides by zero
// and its limit is taken: B0 asks for that on every input.   [Appendix B, Equation 7, C4; docs/integrals.md, section 1]
#include "integral/trigonometry.glslh"

float integral_printed_c4(float phi0, float phi1, float p, float s, float t) {
    // The product is half the difference of two waves, of s - 1 and s + 1 turns. At s = 1 the first does not turn.
    float sum1 = sine((1.0 + s) * phi1 + p + t), sum0 = sine((1.0 + s) * phi0 + p + t);
    float limit = 0.5 * ((phi1 - phi0) * cosine(p - t) - 0.5 * (sum1 - sum0));
    // Named first, or glslang makes a branch of it.
    float elsewhere = 0.5 * ((sine((1.0 - s) * phi1 + p - t) / (1.0 - s) - sum1 / (1.0 + s)) -
                             (sine((1.0 - s) * phi0 + p - t) / (1.0 - s) - sum0 / (1.0 + s)));
    return s == 1.0 ? limit : elsewhere;
}
