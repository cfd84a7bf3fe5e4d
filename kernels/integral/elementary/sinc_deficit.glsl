// D(x) = 1 - sin x / x without the cancellation near 0, where it is x²/6.   [docs/integrals.md, section 3]
#include "integral/trigonometry.glslh"

float integral_elementary_sinc_deficit(float x) {
    float z = x * x;
    // Taylor: at 1.5 the first term left out is 1e-8 of the sum.
    precise float series =
        z * (0.166666667 + z * (-8.33333333e-3 + z * (1.98412698e-4 + z * (-2.75573192e-6 + z * 2.50521084e-8))));
    // Both, and one of them chosen: a branch costs more. NaN is taken for 0, as sin takes it.
    float difference = 1.0 - sine(x) / x, near_0 = abs(x) < 1.5 ? series : 0.0;
    return abs(x) >= 1.5 ? difference : near_0;
}
