// The integral of sin(φ + p) sin(sφ + t) over φ0 … φ1, exactly as printed: divides by 1 - s and 1 + s.
// [Appendix B, Equation 7, C4]
#include "integral/trigonometry.glslh"

float integral_as_printed_c4(float phi0, float phi1, float p, float s, float t) {
    return 0.5 * ((sine((1.0 - s) * phi1 + p - t) / (1.0 - s) - sine((1.0 + s) * phi1 + p + t) / (1.0 + s)) -
                  (sine((1.0 - s) * phi0 + p - t) / (1.0 - s) - sine((1.0 + s) * phi0 + p + t) / (1.0 + s)));
}
