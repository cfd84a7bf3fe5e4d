// Appendix A: the linear fit of the lobe G(x) = μ e^{λ(x-1)} on a … b, by quadrature of the projections that
// define it.
//
// With q = (b-a)/2, m = λq and s measured down from b in units of q (x = b - qs, s from 0 to 2) the lobe is
// g e^{-ms}, g = μ e^{-λ(1-b)}: one function of m, scaled. Its fit in t = 1 - s is ρ0 + ρ1 t with
//     ρ0 = ½ ∫ e^{-ms} ds,  ρ1 = 3/2 ∫ (1-s) e^{-ms} ds.
#pragma once

#include "casegen/reference/integral/quadrature.h"

namespace gnomon::reference::integral {

/// A function of m and its derivative by m.
template <typename R>
struct Slope {
    R value = 0, slope = 0;
};

/// r0 = g·mean, r1 = g·tilt, β = g λ·tilt_by_m.
template <typename R>
struct FitShape {
    Slope<R> mean, tilt, tilt_by_m;
};
/// For Real and Wide; m ≥ 0.
template <typename R>
FitShape<R> fit_shape(const R& m, const Effort& effort = {});
/// The root of ∫ (G - L)² dx is g √q·fit_l2, ∫ |G - L| dx is g q·fit_l1. For Wide.
template <typename R>
Slope<R> fit_l2(const R& m, const FitShape<R>& shape, const Effort& effort = {});
template <typename R>
Slope<R> fit_l1(const R& m, const FitShape<R>& shape, const Effort& effort = {});

/// An interval by its versines and the lobe on it; turned round if need be.
template <typename T>
struct Lobe {
    T of_a, of_b; ///< 1 - a ≥ 1 - b
    T lambda, mu;
    Lobe(const T& va, const T& vb, const T& sharpness, const T& amplitude)
        : of_a(value_of(T(va - vb)) < 0 ? vb : va), of_b(value_of(T(va - vb)) < 0 ? va : vb),
          lambda(sharpness), mu(amplitude) {}
    T q() const { return (of_a - of_b) / T(2); }
    T m() const { return lambda * q(); }
    T versine_of_middle() const { return (of_a + of_b) / T(2); }
    T peak() const { ///< g
        using std::exp;
        return mu * exp(-(lambda * of_b));
    }
};

} // namespace gnomon::reference::integral
