// Equations 8 to 15: integrals over a cell φ0 … φ1, θ0 … kφ + b, by Gauss-Legendre in φ and θ of what stands
// under the integral.
#pragma once

#include "casegen/reference/integral/quadrature.h"

#include <array>

namespace gnomon::reference::integral {

/// φ = middle + half·x for x in [-1, 1]; θ = theta0 + t·rise(x) for t in [0, 1], rise linear from `rise0` at
/// x = -1 to `rise1`. Every integral over the cell is ∫∫ f half·rise(x) dx dt: its sign is that of the area.
template <typename T>
struct Cell {
    T middle, half, theta0, rise0, rise1;
};

/// The cell of φ0, φ1, θ0, k, b. The rises kφ + b - θ0 cancel, for large k nearly all: in multiprecision the
/// numbers that come from floats add up exactly.
template <typename T>
Cell<T> boundary_cell(const T& phi0, const T& phi1, const T& theta0, const T& k, const T& b) {
    return {(phi0 + phi1) / T(2), (phi1 - phi0) / T(2), theta0, k * phi0 + b - theta0, k * phi1 + b - theta0};
}

/// The integrals that all others over a cell are combinations of.
enum Moment : std::size_t {
    sin2_cos_phi,     ///< sin²θ cosφ
    sin2_sin_phi,     ///< sin²θ sinφ
    sin_cos_theta,    ///< sinθ cosθ
    sin3_cos2_phi,    ///< sin³θ cos²φ
    sin3_sin_cos_phi, ///< sin³θ sinφ cosφ
    sin3_sin2_phi,    ///< sin³θ sin²φ
    sin2_cos_cos_phi, ///< sin²θ cosθ cosφ
    sin2_cos_sin_phi, ///< sin²θ cosθ sinφ
    cos2_sin,         ///< cos²θ sinθ
    moment_count
};
template <typename R>
using Moments = std::array<R, moment_count>;

/// NaN beyond `most_frequency`.
Moments<Real> moments(const Cell<Real>& cell, const Effort& effort = {});

/// The same, kept from call to call by the doubles that a cell comes from: several quantities are asked of
/// the same cells.
struct CellKey {
    bool of_boundary; ///< φ0, φ1, θ0, k, b; else φ, half, θ0, rise0, rise1
    std::array<double, 5> numbers;
};
Cell<Real> exact_cell(const CellKey& key);
Moments<Real> kept_moments(const CellKey& key);

// ∫∫ (n·ω) sinθ and ∫∫ (p·ω) (n·ω) sinθ as combinations of moments; `n`, `p` are 3 numbers.
template <typename R>
R first_moment(const Moments<R>& m, const R* n) {
    return n[0] * m[sin2_cos_phi] + n[1] * m[sin2_sin_phi] + n[2] * m[sin_cos_theta];
}
template <typename R>
R second_moment(const Moments<R>& m, const R* n, const R* p) {
    return p[0] * n[0] * m[sin3_cos2_phi] + (p[0] * n[1] + p[1] * n[0]) * m[sin3_sin_cos_phi] +
           p[1] * n[1] * m[sin3_sin2_phi] + (p[0] * n[2] + p[2] * n[0]) * m[sin2_cos_cos_phi] +
           (p[1] * n[2] + p[2] * n[1]) * m[sin2_cos_sin_phi] + p[2] * n[2] * m[cos2_sin];
}

/// The axis whose n·ω is sin(φ + phase) sinθ (equation 4, read backwards).
template <typename T>
std::array<T, 3> axis_of_phase(const T& phase) {
    T s, c;
    sin_cos(phase, s, c);
    return {s, c, T(0)};
}
/// The axis whose n·ω is cosθ.
template <typename T>
std::array<T, 3> polar_axis() {
    return {T(0), T(0), T(1)};
}

/// A direction by its angles.
template <typename T>
struct Direction {
    T sin_theta, cos_theta, sin_phi, cos_phi;
};

/// ∫∫ f(direction) dθ dφ directly, and ∫∫ |f|, where f is of products of three sines at most; for duals.
template <typename T, typename F>
Integral<T> integrate_over(const Cell<T>& cell, const F& f, const Effort& effort) {
    const double rise0 = cell.rise0.value, rise1 = cell.rise1.value;
    const double omega_phi = 1.5 * std::abs(rise1 - rise0) + 2 * std::abs(cell.half.value);
    const double omega_theta = 1.5 * std::max(std::abs(rise0), std::abs(rise1));
    const int panels_phi = panels_for(omega_phi), panels_theta = panels_for(omega_theta);
    const auto& rule_phi = gauss_rule<double>(nodes_for(omega_phi / panels_phi, effort));
    const auto& rule_theta = gauss_rule<double>(nodes_for(omega_theta / panels_theta, effort));
    Integral<T> total;
    const auto add_column = [&](double x, double weight) {
        const T rise = (0.5 * (1 - x)) * cell.rise0 + (0.5 * (1 + x)) * cell.rise1;
        const T width = weight * (rise * cell.half);
        Direction<T> to;
        sin_cos(cell.middle + x * cell.half, to.sin_phi, to.cos_phi);
        T sum = 0;
        double magnitude = 0;
        for (int panel = 0; panel < panels_theta; ++panel)
            for (std::size_t j = 0; j < rule_theta.nodes.size(); ++j) {
                const double t = (panel + 0.5 * (1 + rule_theta.nodes[j])) / panels_theta;
                sin_cos(cell.theta0 + t * rise, to.sin_theta, to.cos_theta);
                const T term = (0.5 * rule_theta.weights[j] / panels_theta) * f(to);
                sum += term;
                magnitude += std::abs(term.value);
            }
        total.value += width * sum;
        total.magnitude += std::abs(width.value) * magnitude;
    };
    for (int panel = 0; panel < panels_phi; ++panel)
        for (std::size_t i = 0; i < rule_phi.nodes.size(); ++i)
            add_column((2 * panel + 1 - panels_phi + rule_phi.nodes[i]) / panels_phi,
                       rule_phi.weights[i] / panels_phi);
    return total;
}

} // namespace gnomon::reference::integral
