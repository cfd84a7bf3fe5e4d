// The light that a cell of a lobe sends past a receiver: the lobe's linear fit times n·ω, over a cell under a linear
// boundary; by as many columns as the fastest wave in φ turns: sin³θ over the boundary's gain, and two dot products over
// the width.
// [Appendix B, Equation 5; docs/integrals.md, sections 3 and 6]
// half_width < 0: the cell from its other end, rise.x first, negated, as is a boundary below θ0; versines are turned
// round; inputs that are not finite: 0.
#include "integral/columns/radiance.glslh"

float integral_mix_radiance(float phi, float half_width, float theta0, vec2 rise, vec3 n, vec3 p, float lambda, float mu,
                            vec2 versines) {
    if (!is_answered(phi, half_width, theta0, rise, n, p, lambda, mu, versines)) return 0.0;
    LitCell cell = lit_cell(phi, half_width, theta0, rise, n, p, lambda, mu, versines);
    // Radians of that wave on half the width. It has an eighth of the integrand at most (sin³θ a quarter of its 3θ, two dot
    // products a half of their 2φ), of which 12 nodes leave 4e-7 at the most there is, 3π/2 + 2π; 8 and 4 leave 6e-10 where
    // they end.
    float wave = 3.0 * abs(cell.gain) + 2.0 * abs(half_width);
    Rule rule = GAUSS_12;
    if (wave < 3.5) rule = GAUSS_8;
    if (wave < 0.5) rule = GAUSS_4;
    return bounded(by_columns(cell, rule));
}
