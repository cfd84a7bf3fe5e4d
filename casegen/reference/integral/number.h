// The numbers that the integrals' truths are computed with.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include <cmath>

namespace gnomon::reference::integral {

/// Three 64-bit limbs. Truths are doubles, and the tests ask for 28 digits; the other 29 are for what
/// cancels: sin³θ at a pole that is 1e-12 away, and β (x - x_m) on a cell of that size.
using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<57, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// For the fits: their errors are differences of order (λq)², squared, and λq may be 1e-20.
using Wide = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<110, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

inline void sin_cos(double x, double& s, double& c) {
    s = std::sin(x);
    c = std::cos(x);
}

template <unsigned digits, boost::multiprecision::mpfr_allocation_type allocation>
void sin_cos(
    const boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits, allocation>,
                                        boost::multiprecision::et_off>& x,
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits, allocation>,
                                  boost::multiprecision::et_off>& s,
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits, allocation>,
                                  boost::multiprecision::et_off>& c) {
    mpfr_sin_cos(s.backend().data(), c.backend().data(), x.backend().data(), MPFR_RNDN);
}

/// The nearest double.
template <typename R>
double value_of(const R& x) {
    return static_cast<double>(x);
}

} // namespace gnomon::reference::integral
