// Equation 7: integrals over φ of products of sines, by quadrature of what stands under the integral.
#pragma once

#include "casegen/reference/integral/quadrature.h"

namespace gnomon::reference::integral {

enum class Wave { c0, c1, c2, c3, c4, c5 };

constexpr std::size_t phases_of(Wave wave) { ///< numbers after φ0, φ1
    constexpr std::array<std::size_t, 6> count{0, 1, 2, 1, 3, 4};
    return count[static_cast<std::size_t>(wave)];
}

/// The integrand of `wave` at φ; `x` are the numbers after φ0, φ1 (p; s, t; p; p, s, t; p, q, s, t).
template <Wave wave, typename T>
T wave_integrand(const T& phi, const T* x) {
    using std::cos, std::sin;
    if constexpr (wave == Wave::c0) return T(1);
    if constexpr (wave == Wave::c1) return sin(phi + x[0]);
    if constexpr (wave == Wave::c2) return cos(x[0] * phi + x[1]);
    if constexpr (wave == Wave::c3) return phi * sin(phi + x[0]);
    if constexpr (wave == Wave::c4) return sin(phi + x[0]) * sin(x[1] * phi + x[2]);
    if constexpr (wave == Wave::c5) return sin(phi + x[0]) * sin(phi + x[1]) * cos(x[2] * phi + x[3]);
}

/// The highest frequency of the integrand, for |s|.
constexpr double wave_frequency(Wave wave, double s) {
    switch (wave) {
    case Wave::c0:
        return 0;
    case Wave::c1:
    case Wave::c3:
        return 1;
    case Wave::c2:
        return s;
    case Wave::c4:
        return s + 1;
    case Wave::c5:
        break;
    }
    return s + 2;
}

/// That frequency over half the interval; `x` is φ0, φ1 and what follows.
template <Wave wave, typename T>
double wave_omega(const std::array<T, 2 + phases_of(wave)>& x) {
    constexpr bool has_s = wave == Wave::c2 || wave == Wave::c4 || wave == Wave::c5;
    const double s = has_s ? std::abs(value_of(x[phases_of(wave)])) : 0;
    return wave_frequency(wave, s) * std::abs(value_of(T(x[1] - x[0]))) / 2;
}

template <Wave wave, typename T>
Integral<T> wave_integral(const std::array<T, 2 + phases_of(wave)>& x, const Effort& effort = {}) {
    return integrate([&](const T& phi) { return wave_integrand<wave>(phi, x.data() + 2); }, x[0], x[1],
                     wave_omega<wave>(x), effort);
}

} // namespace gnomon::reference::integral
