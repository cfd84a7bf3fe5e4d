#include "casegen/reference/integral/quadrature.h"

#include <boost/math/special_functions/legendre.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>

namespace gnomon::reference::integral {
namespace {

constexpr std::size_t largest_rule = 128;

/// Nodes are the zeros of the Legendre polynomial P_n, weights 2 / ((1 - x²) P_n'(x)²).
template <typename R>
Rule<R> make_rule(int n) {
    const std::vector<R> zeros = boost::math::legendre_p_zeros<R>(n); // those ≥ 0, ascending
    Rule<R> rule;
    const auto add = [&](const R& x) {
        const R slope = boost::math::legendre_p_prime(n, x);
        rule.nodes.push_back(x);
        rule.weights.push_back(R(2) / ((R(1) - x * x) * slope * slope));
    };
    for (std::size_t i = zeros.size(); i-- > 0;)
        if (zeros[i] != 0) add(-zeros[i]);
    for (const R& zero : zeros) add(zero);
    return rule;
}

/// log of 2^{2n+1} (n!)⁴ / ((2n+1) (2n)!³).
double log_constant(int n) {
    static const auto all = [] {
        std::array<double, largest_rule + 1> table{};
        double factorial = 0, factorial_of_twice = 0; // their logs
        for (int i = 1; i <= static_cast<int>(largest_rule); ++i) {
            factorial += std::log(i);
            factorial_of_twice += std::log(2.0 * i - 1) + std::log(2.0 * i);
            table[static_cast<std::size_t>(i)] =
                (2 * i + 1) * std::log(2.0) + 4 * factorial - std::log(2.0 * i + 1) - 3 * factorial_of_twice;
        }
        return table;
    }();
    return all[static_cast<std::size_t>(n)];
}

} // namespace

template <typename R>
const Rule<R>& gauss_rule(int n) {
    static std::array<std::once_flag, largest_rule + 1> once;
    static std::array<Rule<R>, largest_rule + 1> rules;
    const auto index = static_cast<std::size_t>(std::clamp<int>(n, 2, largest_rule));
    std::call_once(once[index], [&] {
        if constexpr (std::is_same_v<R, double>) {
            const Rule<Real>& exact = gauss_rule<Real>(static_cast<int>(index));
            for (const Real& x : exact.nodes) rules[index].nodes.push_back(value_of(x));
            for (const Real& w : exact.weights) rules[index].weights.push_back(value_of(w));
        } else {
            rules[index] = make_rule<R>(static_cast<int>(index));
        }
    });
    return rules[index];
}

template const Rule<double>& gauss_rule<double>(int);
template const Rule<Real>& gauss_rule<Real>(int);
template const Rule<Wide>& gauss_rule<Wide>(int);

int nodes_for(double omega, const Effort& effort) {
    const double frequency = std::max(omega, 1e-30);
    const double wanted = -effort.digits * std::log(10.0) + 6 * std::min(0.0, std::log(frequency));
    int n = 2;
    while (n < static_cast<int>(largest_rule) && log_constant(n) + 2 * n * std::log(frequency) > wanted) ++n;
    return std::min(n + effort.extra, static_cast<int>(largest_rule));
}

} // namespace gnomon::reference::integral
