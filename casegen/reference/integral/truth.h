// What the kernels of kernels/integral are judged by: truths in multiprecision, by quadrature of the
// integrals as they are defined, never by the kernels' closed forms. Angles in radians, vectors in the cell's
// frame (z is the pole, φ is measured from x towards y), θ from the pole. Equations are those of Appendices A
// and B of "Analytic Double Product Integrals for All-Frequency Relighting".
//
// Every function takes the numbers of its kernel in the order of the kernel's parameters, as listed.
// Intervals may end before they begin: the integral then changes its sign. An input that is not finite has
// the truth NaN.
#pragma once

#include "casegen/kernel_case.h"

namespace gnomon::reference::integral {

// Equation 7: integrals over φ0 … φ1 of
Truth c0(const Arguments& phi0_phi1);         ///< 1
Truth c1(const Arguments& phi0_phi1_p);       ///< sin(φ + p)
Truth c2(const Arguments& phi0_phi1_s_t);     ///< cos(sφ + t)
Truth c3(const Arguments& phi0_phi1_p);       ///< φ sin(φ + p)
Truth c4(const Arguments& phi0_phi1_p_s_t);   ///< sin(φ + p) sin(sφ + t)
Truth c5(const Arguments& phi0_phi1_p_q_s_t); ///< sin(φ + p) sin(φ + q) cos(sφ + t)

// Equations 8 to 15: integrals over φ0 … φ1 and θ0 … kφ + b of
Truth a0(const Arguments& phi0_phi1_theta0_k_b_tau);       ///< sin(φ + τ) sin²θ
Truth a1(const Arguments& phi0_phi1_theta0_k_b);           ///< cosθ sinθ
Truth a(const Arguments& phi0_phi1_theta0_k_b_n);          ///< (n·ω) sinθ
Truth b0(const Arguments& phi0_phi1_theta0_k_b_gamma_tau); ///< sin(φ + γ) sin(φ + τ) sin³θ
Truth b1(const Arguments& phi0_phi1_theta0_k_b_gamma);     ///< sin(φ + γ) cosθ sin²θ
Truth b2(const Arguments& phi0_phi1_theta0_k_b_tau);       ///< sin(φ + τ) cosθ sin²θ
Truth b3(const Arguments& phi0_phi1_theta0_k_b);           ///< cos²θ sinθ
Truth b(const Arguments& phi0_phi1_theta0_k_b_n_p);        ///< (p·ω)(n·ω) sinθ

/// Equation 5: the integral of (r0 + β (p̂·ω - x_m)) (n·ω) sinθ over φ - half … φ + half and θ0 … θ0 +
/// rise(φ); rise is linear from rise.x to rise.y. r0 and β are the fit of the lobe μ e^(λ(x-1)) on the
/// interval of x = p̂·ω whose versines are (1 - a, 1 - b), x_m its middle; p̂ is p scaled to length 1.
Truth radiance(const Arguments& phi_half_theta0_rise_n_p_lambda_mu_versines);

// Appendix A: the linear fit of μ e^(λ(x-1)) on a … b, by its versines (1 - a, 1 - b); its mean r0, the slope
// r1 over half the interval, α + βx = r0 + β (x - (a+b)/2), and the error: the root of ∫ (G - L)² dx, and ∫
// |G - L| dx. An interval that ends before it begins is turned round.
Truth fit_r0(const Arguments& versines_lambda_mu);
Truth fit_r1(const Arguments& versines_lambda_mu);
Truth fit_alpha(const Arguments& versines_lambda_mu);
Truth fit_beta(const Arguments& versines_lambda_mu);
Truth fit_l2(const Arguments& versines_lambda_mu);
Truth fit_l1(const Arguments& versines_lambda_mu);

// The same by the interval's ends (a, b) themselves, as Appendix A has them.
Truth fit_r0_of_ends(const Arguments& ends_lambda_mu);
Truth fit_r1_of_ends(const Arguments& ends_lambda_mu);
Truth fit_alpha_of_ends(const Arguments& ends_lambda_mu);
Truth fit_beta_of_ends(const Arguments& ends_lambda_mu);

// The interval of x = p̂·ω over the cell φ - half … φ + half, θ.x … θ.y, as the ends (a, b) and as the
// versines (1 - a, 1 - b). By search over the cell, not by a list of candidates.
Truth interval(const Arguments& phi_half_theta_p);
Truth interval_versines(const Arguments& phi_half_theta_p);

} // namespace gnomon::reference::integral
