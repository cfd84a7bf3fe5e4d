// A number with its derivatives by N inputs (forward automatic differentiation): what a truth's conditioning
// is made of, in double.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gnomon::reference::integral {

template <std::size_t N>
struct Dual {
    double value = 0;
    std::array<double, N> by{};

    Dual() = default;
    Dual(double v) : value(v) {} // NOLINT: a constant is a number whose derivatives are 0
    static Dual input(double v, std::size_t index) {
        Dual result(v);
        result.by[index] = 1;
        return result;
    }

    Dual& operator+=(const Dual& o) {
        value += o.value;
        for (std::size_t i = 0; i < N; ++i) by[i] += o.by[i];
        return *this;
    }

    friend Dual operator-(Dual a) { return chain(a, -a.value, -1); }
    friend Dual operator+(Dual a, const Dual& b) { return a += b; }
    friend Dual operator-(Dual a, const Dual& b) {
        a.value -= b.value;
        for (std::size_t i = 0; i < N; ++i) a.by[i] -= b.by[i];
        return a;
    }
    friend Dual operator*(const Dual& a, const Dual& b) {
        Dual result(a.value * b.value);
        for (std::size_t i = 0; i < N; ++i) result.by[i] = a.by[i] * b.value + a.value * b.by[i];
        return result;
    }
    friend Dual operator*(double a, Dual b) { return chain(b, a * b.value, a); }
    friend Dual operator*(Dual a, double b) { return b * a; }
    friend Dual operator/(const Dual& a, const Dual& b) {
        Dual result(a.value / b.value);
        for (std::size_t i = 0; i < N; ++i) result.by[i] = (a.by[i] - result.value * b.by[i]) / b.value;
        return result;
    }

    /// f(x) from f's value and slope there.
    friend Dual chain(Dual x, double f, double slope) {
        x.value = f;
        for (double& d : x.by) d *= slope;
        return x;
    }
    friend Dual sin(const Dual& x) { return chain(x, std::sin(x.value), std::cos(x.value)); }
    friend Dual cos(const Dual& x) { return chain(x, std::cos(x.value), -std::sin(x.value)); }
    friend Dual exp(const Dual& x) { return chain(x, std::exp(x.value), std::exp(x.value)); }
    friend Dual sqrt(const Dual& x) {
        return chain(x, std::sqrt(x.value), x.value == 0 ? 0 : 0.5 / std::sqrt(x.value));
    }
    friend void sin_cos(const Dual& x, Dual& s, Dual& c) {
        const double sine = std::sin(x.value), cosine = std::cos(x.value);
        s = chain(x, sine, cosine);
        c = chain(x, cosine, -sine);
    }
};

template <std::size_t N>
double value_of(const Dual<N>& x) {
    return x.value;
}

} // namespace gnomon::reference::integral
