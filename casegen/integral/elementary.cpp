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

/// Beyond the angles that a float's sine is asked of: up to 65536 the multiple of π/2 has 16 bits, and its
/// product with the 11 of the second part of π/2 is rounded, at 20 to 2^-20; farther the angle is taken for
/// 0. `of` gives the function, 1e-7 is its own tolerance.
constexpr double farthest = 65536;
auto around(Numbers (*of)(double)) {
    return [of](std::span<const double> n) -> std::optional<Bounds> {
        Bounds bounds = exactly(of(std::abs(n[0]) <= farthest ? n[0] : 0));
        if (!(std::abs(n[0]) <= farthest)) return bounds;
        for (double& lower : bounds.lower) lower -= 0x1p-20 + 1e-7;
        for (double& upper : bounds.upper) upper += 0x1p-20 + 1e-7;
        return bounds;
    };
}
/// What NaN gives, and nothing is asked of other inputs.
auto of_nan(double answer) {
    return [answer](std::span<const double> n) -> std::optional<Bounds> {
        if (std::isnan(n[0])) return exactly({answer});
        return {};
    };
}

/// The integral of (cos τ - 1) sin²τ over -d … d, by Simpson's rule on what keeps its sign: no cancellation.
double bent_sine(double d) {
    double sum = 0;
    constexpr int steps = 128;
    for (int i = 0; i <= steps; ++i) {
        const double tau = d * i / steps, s = std::sin(0.5 * tau), across = std::sin(tau);
        sum -= (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * 2 * s * s * across * across;
    }
    return 2 * d * sum / (3 * steps);
}

Parameter angle(double most, const char* meaning) { return {"x", {-most, most, {}}, "radians", meaning}; }

/// Where the power of x that a result is a multiple of is no denormal, and has its digits.
bool is_normal_cubed(const Arguments& with) {
    return with.numbers[0] == 0 || std::abs(with.numbers[0]) > 1e-12;
}
bool is_normal_to_the_fifth(const Arguments& with) {
    return with.numbers[0] == 0 || std::abs(with.numbers[0]) > 1e-7;
}
const char* part_of_columns = "whatever comes of it beyond 0.8, where nothing asks for it";

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
            .outside = around([](double x) { return Numbers{std::sin(x)}; }),
        },
        {
            .name = "integral/elementary/cos",
            .source = "Cody and Waite 1980; Taylor",
            .reference = [](double x) { return std::cos(x); },
            .parameters = {angle(known, "any angle; beyond 65536 it is taken for 0")},
            .result = {-1, 1, "1", "cos x"},
            .tolerance = absolute(1e-7),
            .outside = around([](double x) { return Numbers{std::cos(x)}; }),
        },
        {
            .name = "integral/elementary/turn",
            .source = "Cody and Waite 1980; Taylor",
            .reference = [](double x) { return glm::dvec2(std::cos(x), std::sin(x)); },
            .parameters = {angle(known, "any angle; beyond 65536 it is taken for 0")},
            .result = {-1, 1, "1", "(cos x, sin x)"},
            .tolerance = absolute(1e-7),
            .outside = around([](double x) {
                return Numbers{std::cos(x), std::sin(x)};
            }),
        },
        {
            .name = "integral/elementary/exp",
            .source = "Cody and Waite 1980; Taylor",
            .reference = [](double x) { return std::exp(x); },
            .parameters = {{"x", {-103, 88.5, {}}, "1", "the exponent"}},
            .result = {0, largest, "1", "e^x; above 88.72 it stays, of NaN it is 1"},
            .tolerance = ulps(2),
            .outside = [](std::span<const double> n) -> std::optional<Bounds> {
                if (std::isnan(n[0])) return exactly({1});
                if (n[0] <= -104) return exactly({0}); // less than half the least float
                if (n[0] > 88.72) return Bounds{{std::exp(88.72) * (1 - 0x1p-22)}, {largest}};
                return {};
            },
        },
        {
            .name = "integral/elementary/sinc",
            .source = "docs/integrals.md, section 3",
            .reference = [](double x) { return sinc(x); },
            .parameters = {angle(known, "half the angle that a wave turns by")},
            .result = {-1, 1, "1", "sin x / x, the wave's mean over its value in the middle"},
            .tolerance = absolute(2e-7),
            .outside = [](std::span<const double> n) -> std::optional<Bounds> {
                if (std::isnan(n[0])) return exactly({1});
                if (std::abs(n[0]) > farthest) return Bounds{{-0.0}, {0.0}};
                return Bounds{{sinc(n[0]) - 2e-7}, {sinc(n[0]) + 2e-7}};
            },
        },
        {
            .name = "integral/elementary/sinc_deficit",
            .source = "docs/integrals.md, section 3",
            .reference = [](double x) { return sinc_deficit(x); },
            .parameters = {angle(50, "half the angle that a wave turns by")},
            .result = {-largest, largest, "1", "1 - sin x / x"},
            .tolerance = ulps(4),
            .outside = of_nan(0),
        },
        {
            .name = "integral/elementary/missing_of_sine",
            .source = "docs/integrals.md, section 3",
            .reference = [](double x) { return x * sinc_deficit(x); },
            .parameters = {angle(0.8, "half the angle that a column spans")},
            .result = {-largest, largest, "1", "x - sin x"},
            .tolerance = ulps(4), // four roundings of factors, each an ulp at most
            .where = is_normal_cubed,
            .defended = false,
            .rule = part_of_columns,
        },
        {
            .name = "integral/elementary/bent_sine",
            .source = "docs/integrals.md, section 3",
            .reference = [](double x) { return bent_sine(x); },
            .parameters = {angle(0.8, "half the angle that a column spans")},
            .result = {-largest, largest, "1", "integral of (cos t - 1) sin^2(t) over -x to x"},
            .tolerance = ulps(6), // six, for z is there twice
            .where = is_normal_to_the_fifth,
            .defended = false,
            .rule = part_of_columns,
        },
        {
            .name = "integral/elementary/exprel",
            .source = "docs/integrals.md, section 4",
            .reference = [](double x) { return x == 0 ? 1 : -std::expm1(-x) / x; },
            .parameters = {{"x", {0, 1e6, {}}, "1", "the exponent"}},
            .result = {0, largest, "1", "(1 - e^-x) / x, the mean of e^-t over 0 to x"},
            .tolerance = ulps(8),
            .outside = [](std::span<const double> n) -> std::optional<Bounds> {
                if (std::isnan(n[0])) return exactly({1});
                if (!(n[0] >= -80 && n[0] < 0)) return {};
                const double want = -std::expm1(-n[0]) / n[0], eight_ulps = 8 * 0x1p-23 * want;
                return Bounds{{want - eight_ulps}, {want + eight_ulps}};
            },
        },
    };
}

} // namespace gnomon::integral
