#include "casegen/reference/integral/lobe_fit.h"

#include <algorithm>

namespace gnomon::reference::integral {
namespace {

/// Width of a panel in units of 1/m, and how many of them until e^{-ms} is beneath notice (1e-35).
constexpr int panel_width = 8, panels_with_decay = 10;

/// Calls node(s, weight, e^{-ms}) for a quadrature over s = from … to. Panels are as narrow as the decay asks
/// for where there is any, whatever m is; behind them is one more for all the rest, where only the polynomial
/// part of an integrand is left.
template <typename R, typename Node>
void for_each_node(const R& m, const R& from, const R& to, const Effort& effort, const Node& node) {
    const auto panel = [&](const R& begin, const R& end, double omega, std::vector<R>& decay) {
        // Squares of the remainder decay twice as fast; slopes by m bring one power of s more per factor.
        const Rule<R>& rule = gauss_rule<R>(nodes_for(2 * omega, effort) + 1);
        const R half = (end - begin) / 2, before = exp(R(-m * begin));
        if (decay.empty()) // within a panel: the same in all of one width
            for (const R& x : rule.nodes) decay.push_back(exp(R(-m * half * (1 + x))));
        for (std::size_t i = 0; i < rule.nodes.size(); ++i)
            node(R(begin + half * (1 + rule.nodes[i])), R(half * rule.weights[i]), R(before * decay[i]));
    };
    std::vector<R> of_full, of_last;
    R begin = from;
    const R width = panel_width / m;
    for (int i = 0; i < panels_with_decay && to - begin > width; ++i, begin += width)
        panel(begin, begin + width, 0.5 * panel_width, of_full);
    if (begin < to) panel(begin, to, std::min(0.5 * panel_width, value_of(R(m * (to - begin))) / 2), of_last);
}

/// Lobe less fit.
template <typename R>
Slope<R> remainder(const FitShape<R>& shape, const R& s, const R& e) {
    return {R(e - shape.mean.value - shape.tilt.value * (1 - s)),
            R(-s * e - shape.mean.slope - shape.tilt.slope * (1 - s))};
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
Slope<R> fit_l2(const R& m, const FitShape<R>& shape, const Effort& effort) {
    if (m == 0) return {};
    R squares = 0, products = 0;
    for_each_node<R>(m, 0, 2, effort, [&](const R& s, const R& weight, const R& e) {
        const Slope<R> d = remainder(shape, s, e);
        squares += weight * d.value * d.value;
        products += weight * d.value * d.slope;
    });
    const R root = sqrt(squares);
    return {root, R(products / root)};
}

template <typename R>
Slope<R> fit_l1(const R& m, const FitShape<R>& shape, const Effort& effort) {
    if (m == 0) return {};
    const R first = crossing<R>(m, shape, 0), last = crossing<R>(m, shape, 2);
    Slope<R> sum;
    const auto add = [&](const R& from, const R& to, int sign) {
        for_each_node<R>(m, from, to, effort, [&](const R& s, const R& weight, const R& e) {
            const Slope<R> d = remainder(shape, s, e);
            sum.value += sign * weight * d.value;
            sum.slope += sign * weight * d.slope; // that the crossings move changes nothing: there d is 0
        });
    };
    add(0, first, 1);
    add(first, last, -1);
    add(last, 2, 1);
    return sum;
}

template FitShape<Real> fit_shape(const Real&, const Effort&);
template FitShape<Wide> fit_shape(const Wide&, const Effort&);
template Slope<Wide> fit_l2(const Wide&, const FitShape<Wide>&, const Effort&);
template Slope<Wide> fit_l1(const Wide&, const FitShape<Wide>&, const Effort&);

} // namespace gnomon::reference::integral
