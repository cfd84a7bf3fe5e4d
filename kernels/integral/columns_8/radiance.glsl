// The light that a cell of a lobe sends past a receiver: the lobe's linear fit times n·ω, over a cell under a linear
// boundary; by 8 columns, each exact in θ about its middle.   [Appendix B, Equation 5; docs/integrals.md, sections 3 and 4]
// half_width < 0: the cell from its other end, rise.x first, negated, as is a boundary below θ0; versines are turned
// round; inputs that are not finite: 0.
#include "integral/columns/radiance.glslh"

float integral_columns_8_radiance(float phi, float half_width, float theta0, vec2 rise, vec3 n, vec3 p, float lambda,
                                  float mu, vec2 versines) {
    if (!is_answered(phi, half_width, theta0, rise, n, p, lambda, mu, versines)) return 0.0;
    return bounded(by_columns(lit_cell(phi, half_width, theta0, rise, n, p, lambda, mu, versines), GAUSS_8));
}
