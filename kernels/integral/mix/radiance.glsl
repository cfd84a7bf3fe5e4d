// The light that a cell of a lobe sends past a receiver: the lobe's linear fit times n·ω, over a cell under a linear boundary.
// Small cells by 4 x 4 centred nodes, for their fit's α and βx would cancel; the others exactly in θ, by as many nodes in
// φ as the fastest wave there turns: sin³θ over the boundary's gain, and two dot products over the width.
// [Appendix B, Equation 5; integrals.md, sections 3 and 6]
// A reversed interval of φ or θ negates the result, one of x is turned round; inputs that are not finite: 0.
#include "integral/centred/radiance.glslh"
#include "integral/exact_theta/radiance.glslh"

float integral_mix_radiance(float phi, float half_width, float theta0, vec2 rise, vec3 n, vec3 p, float lambda, float mu, vec2 versines) {
    if (!is_answered(phi, half_width, theta0, rise, n, p, lambda, mu, versines)) return 0.0;
    LitCell cell = lit_cell(phi, half_width, theta0, rise, n, p, lambda, mu, versines);
    float turns = 3.0 * abs(cell.gain) + 2.0 * abs(half_width); // radians of that wave on half the width
    if (turns < 0.6 && 1.5 * max(abs(rise.x), abs(rise.y)) < 0.6) return bounded(centred(cell, GAUSS_4));
    return bounded(exact_in_theta(cell, turns > 5.0 ? GAUSS_12 : GAUSS_8));
}
