// The fits and the radiance before they are rounded to double: what their truths are, and what the tests
// compare.
#pragma once

#include "casegen/reference/integral/cell.h"
#include "casegen/reference/integral/lobe_fit.h"

namespace gnomon::reference::integral {

enum class Fit { r0, r1, alpha, beta, l2, l1 };

/// What the fit is made of, for any type of number. `apply` makes a number of a function of m and its slope.
template <typename T>
struct FitParts {
    T r0, r1, beta, x_m;
};
template <typename T, typename Apply>
FitParts<T> fit_parts(const Lobe<T>& lobe, const FitShape<Wide>& shape, const Apply& apply) {
    const T peak = lobe.peak();
    return {peak * apply(shape.mean), peak * apply(shape.tilt), peak * lobe.lambda * apply(shape.tilt_by_m),
            T(1) - lobe.versine_of_middle()};
}

template <typename T, typename Apply>
T fit_result(Fit what, const Lobe<T>& lobe, const FitShape<Wide>& shape, const Slope<Wide>& error,
             const Apply& apply) {
    using std::sqrt;
    const FitParts<T> parts = fit_parts(lobe, shape, apply);
    // An error has no sign, though the lobe has.
    const T height = value_of(lobe.mu) < 0 ? T(-lobe.peak()) : T(lobe.peak());
    switch (what) {
    case Fit::r0:
        return parts.r0;
    case Fit::r1:
        return parts.r1;
    case Fit::alpha:
        return parts.r0 - parts.beta * parts.x_m;
    case Fit::beta:
        return parts.beta;
    case Fit::l2:
        return height * sqrt(lobe.q()) * apply(error);
    case Fit::l1:
        break;
    }
    return height * lobe.q() * apply(error);
}

inline Slope<Wide> fit_error(Fit what, const Wide& m, const FitShape<Wide>& shape,
                             const Effort& effort = {}) {
    return what == Fit::l2   ? fit_l2(m, shape, effort)
           : what == Fit::l1 ? fit_l1(m, shape, effort)
                             : Slope<Wide>{};
}

/// `x`: the interval's versines, or its ends, λ, μ.
inline Lobe<Wide> exact_lobe(const double* x, bool of_ends) {
    const Wide first = x[0], second = x[1];
    return {of_ends ? Wide(1 - first) : first, of_ends ? Wide(1 - second) : second, Wide(x[2]), Wide(x[3])};
}
inline Wide fit_value(Fit what, const double* x, bool of_ends, const Effort& effort = {}) {
    const Lobe<Wide> lobe = exact_lobe(x, of_ends);
    const FitShape<Wide> shape = fit_shape(lobe.m(), effort);
    return fit_result(what, lobe, shape, fit_error(what, lobe.m(), shape, effort),
                      [](const Slope<Wide>& f) { return f.value; });
}

// Of the radiance's numbers: φ, half, θ0, rise (2), n (3), p (3), λ, μ, versines (2).
template <typename Numbers>
Lobe<Wide> radiance_lobe(const Numbers& x) {
    return {Wide(x[13]), Wide(x[14]), Wide(x[11]), Wide(x[12])};
}
/// `m` are the cell's moments.
template <typename Numbers>
Real radiance_value(const Numbers& x, const Moments<Real>& m, const Lobe<Wide>& lobe,
                    const FitShape<Wide>& shape) {
    const auto parts = fit_parts(lobe, shape, [](const Slope<Wide>& f) { return f.value; });
    const Real length = sqrt(Real(x[8]) * x[8] + Real(x[9]) * x[9] + Real(x[10]) * x[10]);
    const Real n[3] = {x[5], x[6], x[7]}, p[3] = {x[8] / length, x[9] / length, x[10] / length};
    const Real first = first_moment(m, n);
    return Real(parts.r0) * first + Real(parts.beta) * (second_moment(m, n, p) - Real(parts.x_m) * first);
}

} // namespace gnomon::reference::integral
