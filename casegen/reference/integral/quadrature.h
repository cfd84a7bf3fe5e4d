// Gauss-Legendre rules of any order and type of number, and how many nodes an oscillating integrand takes.
#pragma once

#include "casegen/reference/integral/dual.h"
#include "casegen/reference/integral/number.h"

#include <vector>

namespace gnomon::reference::integral {

/// Nodes in [-1, 1], ascending, and their weights.
template <typename R>
struct Rule {
    std::vector<R> nodes, weights;
};

/// The rule of n nodes: made once, kept for the life of the process. For double, Real and Wide.
template <typename R>
const Rule<R>& gauss_rule(int n);

/// What a quadrature is to reach, relative to the integral of the integrand's absolute value. `extra` nodes
/// per panel show whether it does.
struct Effort {
    double digits = 30;
    int extra = 1;
};

/// Nodes for e^{iωx} on [-1, 1]. The rule's error is at most 2^{2n+1} (n!)⁴ / ((2n+1) (2n)!³) · ω^{2n}; below
/// ω = 1 it is asked to be smaller by ω⁶, because low frequencies come with integrands that all but vanish
/// (sines at a zero, remainders of a fit).
int nodes_for(double omega, const Effort& effort);

/// Panels keep rules small: at most this frequency in each.
constexpr double panel_frequency = 12;
/// Beyond this nothing is computed: such an integrand is no question that a kernel is asked.
constexpr double most_frequency = 20000;
inline int panels_for(double omega) {
    return omega <= panel_frequency ? 1 : static_cast<int>(omega / panel_frequency) + 1;
}

template <typename T>
struct NodeOf {
    using type = T;
};
template <std::size_t N>
struct NodeOf<Dual<N>> {
    using type = double;
};

inline double magnitude_of(double x) { return std::abs(x); }
template <std::size_t N>
double magnitude_of(const Dual<N>& x) {
    return std::abs(x.value);
}
/// Of multiprecision numbers none is kept: it would cost more than the sum.
inline double magnitude_of(const Real&) { return 0; }
inline double magnitude_of(const Wide&) { return 0; }

/// An integral, and that of the integrand's absolute value to a few per cent.
template <typename T>
struct Integral {
    T value = 0;
    double magnitude = 0;
};

/// ∫ f(x) dx from `lower` to `upper`, f's frequencies being at most `omega` over half that length.
template <typename T, typename F>
Integral<T> integrate(const F& f, const T& lower, const T& upper, double omega, const Effort& effort) {
    const T middle = (lower + upper) / T(2), half = (upper - lower) / T(2);
    const int panels = panels_for(omega);
    const auto& rule = gauss_rule<typename NodeOf<T>::type>(nodes_for(omega / panels, effort));
    Integral<T> sum;
    for (int panel = 0; panel < panels; ++panel) {
        const T centre = middle + half * (T(2 * panel + 1 - panels) / T(panels));
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const T term = f(centre + half * (T(rule.nodes[i]) / T(panels))) * T(rule.weights[i]);
            sum.value = sum.value + term;
            sum.magnitude += magnitude_of(term);
        }
    }
    const T scale = half / T(panels);
    return {sum.value * scale, sum.magnitude * magnitude_of(scale)};
}

} // namespace gnomon::reference::integral
