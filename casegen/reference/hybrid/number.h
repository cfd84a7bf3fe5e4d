// The numbers that the hybrid kernels' truths are computed with: many digits for the value, and doubles that
// carry their derivatives for what rounding the inputs can do to it.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/reference/integral/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gnomon::reference::hybrid {

using integral::Real;

/// A double and its derivatives by a kernel's arguments.
struct Dual {
    double value = 0;
    std::array<double, 16> by{};

    Dual() = default;
    Dual(double v) : value(v) {} // NOLINT: formulas read Dual(1) - x as 1 - x
};

inline Dual combined(double value, const Dual& a, double by_a, const Dual& b, double by_b) {
    Dual result(value);
    for (std::size_t i = 0; i < result.by.size(); ++i) result.by[i] = by_a * a.by[i] + by_b * b.by[i];
    return result;
}
inline Dual operator+(const Dual& a, const Dual& b) { return combined(a.value + b.value, a, 1, b, 1); }
inline Dual operator-(const Dual& a, const Dual& b) { return combined(a.value - b.value, a, 1, b, -1); }
inline Dual operator-(const Dual& a) { return combined(-a.value, a, -1, a, 0); }
inline Dual operator*(const Dual& a, const Dual& b) {
    return combined(a.value * b.value, a, b.value, b, a.value);
}
inline Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return combined(quotient, a, 1 / b.value, b, -quotient / b.value);
}
inline bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
inline bool operator>(const Dual& a, const Dual& b) { return b < a; }
inline Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return combined(root, a, 0.5 / root, a, 0);
}
inline Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }

/// The truth of `formula`, a function of 16 numbers of any type to an array of numbers, when each argument is
/// rounded by half an ulp not of itself but of its `magnitudes` entry: differences of coordinates are rounded
/// by what the larger ones are.
template <typename Formula>
Truth truth_of(const Arguments& arguments, std::span<const double> magnitudes, const Formula& formula) {
    std::array<Real, 16> exact;
    std::array<Dual, 16> varied;
    for (std::size_t i = 0; i < magnitudes.size(); ++i) {
        exact[i] = arguments.numbers[i];
        varied[i] = arguments.numbers[i];
        varied[i].by[i] = 1;
    }
    const auto value = formula(exact);
    const auto derivative = formula(varied);
    Truth truth;
    for (std::size_t k = 0; k < value.size(); ++k) {
        truth.value[k] = static_cast<double>(value[k]);
        for (std::size_t i = 0; i < magnitudes.size(); ++i)
            truth.conditioning[k] += 0x1p-24 * magnitudes[i] * std::abs(derivative[k].by[i]);
        truth.scale = std::max(truth.scale, std::abs(truth.value[k]));
    }
    return truth;
}

} // namespace gnomon::reference::hybrid
