// The integral of φ sin(φ + p) over φ0 … φ1, as printed.   [Appendix B, Equation 7, C3]
#include "integral/trigonometry.glslh"

float integral_printed_c3(float phi0, float phi1, float p) {
    return (sine(phi1 + p) - phi1 * cosine(phi1 + p)) - (sine(phi0 + p) - phi0 * cosine(phi0 + p));
}
