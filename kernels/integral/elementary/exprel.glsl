// (1 - e^-x) / x, 1 at 0: the mean of e^-t over 0 … x, without the cancellation near 0.
#include "integral/trigonometry.glslh"

float integral_elementary_exprel(float x) {
    // Taylor: at 0.5 the first term left out is 1e-9.
    precise float series =
        1.0 -
        x * (0.5 - x * (0.166666667 - x * (4.16666667e-2 - x * (8.33333333e-3 - x * (1.38888889e-3 - x * 1.98412698e-4)))));
    precise float direct = (1.0 - exponential(-x)) / x;
    // NaN is taken for 0.
    return abs(x) >= 0.5 ? direct : abs(x) < 0.5 ? series : 1.0;
}
