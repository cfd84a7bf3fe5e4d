#include "casegen/reference/integral/lobe_fit.h"

#include <algorithm>

namespace gnomon::reference::integral {
namespace {

/// Width of a panel in units of 1/m, and how many of them until e^{-ms} is beneath notice (1e-69).
constexpr int panel_width = 8, panels_with_decay = 20;

/// Calls node(s, weight, e^{-ms}) for a quadrature over s = from … to. Panels are as narrow as the decay asks
/// for where there is any, whatever m is; behind them is one more for all the rest, where only the polynomial
/// part of an integrand is left.
template <typename R, typename Node>
void for_each_node(const R& m, const R& from, const R& to, const Effort& effort, const Node& node) {
    using std::exp;
    const auto panel = [&](const R& begin, const R& end, double omega) {
        const R middle = (begin + end) / 2, half = (end - begin) / 2;
        // Squares of the remainder decay twice as fast; slopes by m bring one power of s more per factor.
        const Rule<R>& rule = gauss_rule<R>(nodes_for(2 * omega, effort) + 1);
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const R s = middle + half * rule.nodes[i];
            node(s, half * rule.weights[i], R(exp(-m * s)));
        }
    };
    if (m * (to - from) <= panel_width) {
        panel(from, to, value_of(R(m * (to - from))) / 2);
        return;
    }
    R begin = from;
    for (int i = 0; i < panels_with_decay && begin < to && m * begin < panel_width * panels_with_decay; ++i) {
        const R end = std::min<R>(to, begin + panel_width / m);
        panel(begin, end, 0.5 * panel_width);
        begin = end;
    }
    if (begin < to) panel(begin, to, 1);
}

/// Where the lobe crosses the fit, in s: two places, because an exponential is convex and a line is not.
/// Newton's method from either end of the interval runs down a convex function without stepping over.
template <typename R>
R crossing(const R& m, const FitShape<R>& shape, R s) {
    using std::abs, std::exp;
    for (int step = 0; step < 1000; ++step) {
        const R e = exp(-m * s);
        const R value = e - shape.mean.value - shape.tilt.value * (1 - s);
        const R slope = -m * e + shape.tilt.value;
        const R moved = value / slope;
        if (!(abs(moved) < 4)) break;
        s -= moved;
        // Newton doubles the digits: the step after one this small is below what s can hold.
        if (abs(moved) < 1e-30) break;
    }
    return std::clamp<R>(s, 0, 2);
}

} // namespace

template <typename R>
FitShape<R> fit_shape(const R& m, const Effort& effort) {
    FitShape<R> shape;
    if (m == 0) {
        shape.mean = {1, -1};
        shape.tilt = {0, 1};
        shape.tilt_by_m = {1, -1};
        return shape;
    }
    for_each_node<R>(m, 0, 2, effort, [&](const R& s, const R& weight, const R& e) {
        const R we = weight * e, wet = we * (1 - s);
        shape.mean.value += we;
        shape.mean.slope -= we * s;
        shape.tilt.value += wet;
        shape.tilt.slope -= wet * s;
    });
    for (R* x : {&shape.mean.value, &shape.mean.slope}) *x /= 2;
    for (R* x : {&shape.tilt.value, &shape.tilt.slope}) *x = *x * 3 / 2;
    shape.tilt_by_m = {shape.tilt.value / m, (shape.tilt.slope - shape.tilt.value / m) / m};
    return shape;
}

template <typename R>
FitError<R> fit_error(const R& m, const FitShape<R>& shape, const Effort& effort) {
    using std::sqrt;
    FitError<R> error;
    if (m == 0) return error;
    const auto remainder = [&](const R& s, const R& e) {
        return Slope<R>{e - shape.mean.value - shape.tilt.value * (1 - s),
                        -s * e - shape.mean.slope - shape.tilt.slope * (1 - s)};
    };
    R squares = 0, products = 0;
    for_each_node<R>(m, 0, 2, effort, [&](const R& s, const R& weight, const R& e) {
        const Slope<R> d = remainder(s, e);
        squares += weight * d.value * d.value;
        products += weight * d.value * d.slope;
    });
    error.l2.value = sqrt(squares);
    error.l2.slope = products / error.l2.value;

    const R first = crossing<R>(m, shape, 0), last = crossing<R>(m, shape, 2);
    const auto add = [&](const R& from, const R& to, int sign) {
        for_each_node<R>(m, from, to, effort, [&](const R& s, const R& weight, const R& e) {
            const Slope<R> d = remainder(s, e);
            error.l1.value += sign * weight * d.value;
            error.l1.slope += sign * weight * d.slope;
        });
    };
    add(0, first, 1);
    add(first, last, -1);
    add(last, 2, 1);
    return error;
}

template FitShape<Real> fit_shape(const Real&, const Effort&);
template FitShape<Wide> fit_shape(const Wide&, const Effort&);
template FitError<Real> fit_error(const Real&, const FitShape<Real>&, const Effort&);
template FitError<Wide> fit_error(const Wide&, const FitShape<Wide>&, const Effort&);

} // namespace gnomon::reference::integral
