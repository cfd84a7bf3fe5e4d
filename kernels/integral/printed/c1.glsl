// The integral of sin(φ + p) over φ0 … φ1, as printed.   [Appendix B, Equation 7, C1]
#include "integral/trigonometry.glslh"

float integral_printed_c1(float phi0, float phi1, float p) { return -cosine(phi1 + p) + cosine(phi0 + p); }
