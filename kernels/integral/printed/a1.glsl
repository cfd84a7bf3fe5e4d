// The integral of cosθ sinθ over φ0 … φ1 and θ0 … kφ + b, as printed.   [Appendix B, Equation 10, A1]
#include "integral/trigonometry.glslh"

float integral_printed_a1(float phi0, float phi1, float theta0, float k, float b) {
    float whole = -(2.0 * (k * phi1 + b) + sine(2.0 * k * phi1 + 2.0 * b)) / (8.0 * k) +
                  (2.0 * (k * phi0 + b) + sine(2.0 * k * phi0 + 2.0 * b)) / (8.0 * k);
    float c = cosine(theta0), under = c * c / 2.0;
    return whole + (under * phi1 - under * phi0);
}
