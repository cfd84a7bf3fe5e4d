// The light that a cell of a lobe sends past a receiver: the lobe's linear fit times n·ω, over a cell under a linear
// boundary; by Gauss–Legendre with 4 x 4 nodes, the fit about its interval's middle.   [Appendix B, Equation 5;
// docs/integrals.md, section 6]
// half_width < 0: the cell from its other end, rise.x first, negated, as is a boundary below θ0; versines are turned
// round; inputs that are not finite: 0.
#include "integral/centred/radiance.glslh"

float integral_centred_4_radiance(float phi, float half_width, float theta0, vec2 rise, vec3 n, vec3 p, float lambda,
                                  float mu, vec2 versines) {
    if (!is_answered(phi, half_width, theta0, rise, n, p, lambda, mu, versines)) return 0.0;
    return bounded(centred(lit_cell(phi, half_width, theta0, rise, n, p, lambda, mu, versines), GAUSS_4));
}
