// The light that a cell of a lobe sends past a receiver: the lobe's linear fit times n·ω, over a cell under a linear
// boundary; exactly as printed, by α, β, k and b.   [Appendix B, Equation 5]
#include "integral/fit_printed/alpha.glsl"
#include "integral/fit_printed/beta.glsl"
#include "integral/printed/a.glsl"
#include "integral/as_printed/b.glsl"
#include "integral/printed/cell.glslh"

float integral_as_printed_radiance(float phi, float half_width, float theta0, vec2 rise, vec3 n, vec3 p, float lambda,
                                   float mu, vec2 versines) {
    PrintedCell cell = printed_cell(phi, half_width, theta0, rise, versines);
    PrintedLobe lobe = printed_lobe(cell.ends, lambda, mu);
    float r1 = printed_r1(lobe, lambda);
    float alpha = printed_alpha(cell.ends, printed_r0(lobe, lambda), r1), beta = printed_beta(cell.ends, r1);
    return alpha * integral_printed_a(cell.phi0, cell.phi1, theta0, cell.k, cell.b, n) +
           beta * integral_as_printed_b(cell.phi0, cell.phi1, theta0, cell.k, cell.b, n, p);
}
