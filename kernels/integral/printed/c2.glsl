// The integral of cos(sφ + t) over φ0 … φ1, as printed: divides by s.   [Appendix B, Equation 7, C2]
#include "integral/trigonometry.glslh"

float integral_printed_c2(float phi0, float phi1, float s, float t) {
    return sine(s * phi1 + t) / s - sine(s * phi0 + t) / s;
}
