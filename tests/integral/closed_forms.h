// The closed forms of Appendices A and B as they are printed, in enough digits that what cancels in them near
// their singularities does not matter: a second opinion on the quadratures. Not for inputs on a singularity,
// but for C4's s = 1, on which B0 calls it whatever its inputs.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include <array>

namespace gnomon::closed {

using Digits = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<200, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

// Equation 7.
inline Digits c0(const Digits& phi0, const Digits& phi1) { return phi1 - phi0; }
inline Digits c1(const Digits& phi0, const Digits& phi1, const Digits& p) {
    return cos(phi0 + p) - cos(phi1 + p);
}
inline Digits c2(const Digits& phi0, const Digits& phi1, const Digits& s, const Digits& t) {
    return (sin(s * phi1 + t) - sin(s * phi0 + t)) / s;
}
inline Digits c3(const Digits& phi0, const Digits& phi1, const Digits& p) {
    const auto at = [&](const Digits& phi) { return Digits(sin(phi + p) - phi * cos(phi + p)); };
    return at(phi1) - at(phi0);
}
inline Digits c4(const Digits& phi0, const Digits& phi1, const Digits& p, const Digits& s, const Digits& t) {
    const auto at = [&](const Digits& phi) {
        const Digits sum = sin((1 + s) * phi + p + t) / (1 + s);
        if (s == 1)
            return Digits((phi * cos(p - t) - sum) / 2); // the limit: a sine over what it vanishes with
        return Digits((sin((1 - s) * phi + p - t) / (1 - s) - sum) / 2);
    };
    return at(phi1) - at(phi0);
}
inline Digits c5(const Digits& phi0, const Digits& phi1, const Digits& p, const Digits& q, const Digits& s,
                 const Digits& t) {
    const auto at = [&](const Digits& phi) {
        return Digits(sin(s * phi + t) * cos(p - q) / (2 * s) -
                      sin((s - 2) * phi + t - p - q) / (4 * (s - 2)) -
                      sin((s + 2) * phi + t + p + q) / (4 * (s + 2)));
    };
    return at(phi1) - at(phi0);
}

struct Boundary {
    Digits phi0, phi1, theta0, k, b;
};

// Equations 9, 10, 12 to 15.
inline Digits a0(const Boundary& x, const Digits& tau) {
    return (2 * x.k * c3(x.phi0, x.phi1, tau) - c4(x.phi0, x.phi1, tau, 2 * x.k, 2 * x.b) +
            (2 * x.b - 2 * x.theta0 + sin(2 * x.theta0)) * c1(x.phi0, x.phi1, tau)) /
           4;
}
inline Digits a1(const Boundary& x) {
    const auto at = [&](const Digits& phi) {
        const Digits twice = 2 * (x.k * phi + x.b), c = cos(x.theta0);
        return Digits(-(twice + sin(twice)) / (8 * x.k) + c * c * phi / 2);
    };
    return at(x.phi1) - at(x.phi0);
}
inline Digits b0(const Boundary& x, const Digits& gamma, const Digits& tau) {
    return (c5(x.phi0, x.phi1, gamma, tau, 3 * x.k, 3 * x.b) - 9 * c5(x.phi0, x.phi1, gamma, tau, x.k, x.b) -
            (cos(3 * x.theta0) - 9 * cos(x.theta0)) * c4(x.phi0, x.phi1, gamma, 1, tau)) /
           12;
}
inline Digits b1(const Boundary& x, const Digits& gamma) { // and B2, with τ
    return (3 * c4(x.phi0, x.phi1, gamma, x.k, x.b) - c4(x.phi0, x.phi1, gamma, 3 * x.k, 3 * x.b) -
            (3 * sin(x.theta0) - sin(3 * x.theta0)) * c1(x.phi0, x.phi1, gamma)) /
           12;
}
inline Digits b3(const Boundary& x) {
    return -(c2(x.phi0, x.phi1, 3 * x.k, 3 * x.b) + 3 * c2(x.phi0, x.phi1, x.k, x.b) -
             (cos(3 * x.theta0) + 3 * cos(x.theta0)) * c0(x.phi0, x.phi1)) /
           12;
}

// Equations 8 and 11, with equation 4's u, v and angles.
using Vector = std::array<Digits, 3>;
inline Digits length_across(const Vector& n) { return sqrt(n[0] * n[0] + n[1] * n[1]); }
inline Digits phase(const Vector& n) { return atan2(n[0], n[1]); }
inline Digits a(const Boundary& x, const Vector& n) {
    return length_across(n) * a0(x, phase(n)) + n[2] * a1(x);
}
inline Digits b(const Boundary& x, const Vector& n, const Vector& p) {
    const Digits up = length_across(p), un = length_across(n);
    return up * un * b0(x, phase(p), phase(n)) + up * n[2] * b1(x, phase(p)) + p[2] * un * b1(x, phase(n)) +
           p[2] * n[2] * b3(x);
}

/// Equations 1 and 2, of the interval's ends.
struct Fit {
    Digits r0, r1, alpha, beta;
};
inline Fit fit(const Digits& a, const Digits& b, const Digits& lambda, const Digits& mu) {
    const Digits p = (a + b) / 2, q = (b - a) / 2, m = lambda * q, c = mu * exp(lambda * (p - 1));
    const Digits sine = (exp(m) - exp(-m)) / 2, cosine = (exp(m) + exp(-m)) / 2;
    const Digits r0 = c * sine / m, r1 = 3 * c * (m * cosine - sine) / (m * m);
    return {r0, r1, r0 - r1 * (a + b) / (b - a), 2 * r1 / (b - a)};
}
/// The root of ∫ (G - L)² dx: by Parseval ∫ G² less what the fit has of it.
inline Digits l2(const Digits& a, const Digits& b, const Digits& lambda, const Digits& mu) {
    const Fit f = fit(a, b, lambda, mu);
    const Digits squares = mu * mu * (exp(2 * lambda * (b - 1)) - exp(2 * lambda * (a - 1))) / (2 * lambda);
    return sqrt(squares - (b - a) * (f.r0 * f.r0 + f.r1 * f.r1 / 3));
}

/// Equation 5 with α* = α, p* = βp.
inline Digits radiance(const Boundary& x, const Vector& n, const Vector& p, const Fit& f) {
    return f.alpha * a(x, n) + b(x, n, {f.beta * p[0], f.beta * p[1], f.beta * p[2]});
}

} // namespace gnomon::closed
