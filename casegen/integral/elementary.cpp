// kernels/integral/elementary: judged by the C library's functions of doubles, which are right far beyond a
// float.
#include "casegen/integral/quantity.h"

#include <cmath>

namespace gnomon::integral {
namespace {

double sinc(double x) { return x == 0 ? 1 : std::sin(x) / x; }
/// 1 - sin x / x as the mean of 1 - cos over 0 … x, by Simpson's rule on halves of the angle: no
/// cancellation.
double sinc_deficit(double x) {
    if (std::abs(x) > 3) return 1 - sinc(x);
    double sum = 0;
    constexpr int steps = 64;
    for (int i = 0; i <= steps; ++i) {
        const double s = std::sin(0.5 * x * i / steps);
        sum += (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * 2 * s * s;
    }
    return sum / (3 * steps);
}

Parameter angle(double most, const char* meaning) { return {"x", {-most, most, {}}, "radians", meaning}; }

} // namespace

std::vector<Case> elementary_cases() {
    constexpr double known = 8192; // beyond, the multiples of π/2 that are taken off are no longer exact
    return {
        {
            .name = "integral/elementary/sin",
            .source = "Cody and Waite 1980; Taylor",
            .reference = [](double x) { return std::sin(x); },
            .parameters = {angle(known, "any angle; beyond 65536 it is taken for 0")},
            .result = {-1, 1, "1", "sin x"},
            .tolerance = absolute(
                1e-7), // a float's rounding below 1, the rest of the reduction, the polynomial's sums
        },
        {
            .name = "integral/elementary/cos",
            .source = "Cody and Waite 1980; Taylor",
            .reference = [](double x) { return std::cos(x); },
            .parameters = {angle(known, "any angle; beyond 65536 it is taken for 0")},
            .result = {-1, 1, "1", "cos x"},
            .tolerance = absolute(1e-7),
        },
        {
            .name = "integral/elementary/turn",
            .source = "Cody and Waite 1980; Taylor",
            .reference = [](double x) { return glm::dvec2(std::cos(x), std::sin(x)); },
            .parameters = {angle(known, "any angle; beyond 65536 it is taken for 0")},
            .result = {-1, 1, "1", "(cos x, sin x)"},
            .tolerance = absolute(1e-7),
        },
        {
            .name = "integral/elementary/exp",
            .source = "Cody and Waite 1980; Taylor",
            .reference = [](double x) { return std::exp(x); },
            .parameters = {{"x", {-103, 88.5, {}}, "1", "the exponent"}},
            .result = {0, largest, "1", "e^x; above 88.72 the largest float, of NaN 1"},
            .tolerance = ulps(2),
        },
        {
            .name = "integral/elementary/sinc",
            .source = "docs/integrals.md, section 3",
            .reference = [](double x) { return sinc(x); },
            .parameters = {angle(known, "half the angle that a wave turns by")},
            .result = {-1, 1, "1", "sin x / x, the wave's mean over its value in the middle"},
            .tolerance = absolute(2e-7),
        },
        {
            .name = "integral/elementary/sinc_deficit",
            .source = "docs/integrals.md, section 3",
            .reference = [](double x) { return sinc_deficit(x); },
            .parameters = {angle(50, "half the angle that a wave turns by")},
            .result = {-largest, largest, "1", "1 - sin x / x"},
            .tolerance = ulps(4),
        },
        {
            .name = "integral/elementary/exprel",
            .source = "docs/integrals.md, section 4",
            .reference = [](double x) { return x == 0 ? 1 : -std::expm1(-x) / x; },
            .parameters = {{"x", {0, 1e6, {}}, "1", "the exponent"}},
            .result = {0, largest, "1", "(1 - e^-x) / x, the mean of e^-t over 0 to x"},
            .tolerance = ulps(8),
        },
    };
}

} // namespace gnomon::integral
