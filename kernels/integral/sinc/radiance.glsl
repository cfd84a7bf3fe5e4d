// The light that a cell of a lobe sends past a receiver: the lobe's linear fit times n·ω, over a cell under a linear
// boundary; by waves without a division, but by α, k and b.   [Appendix B, Equation 5; docs/integrals.md, section 3]
// half_width < 0: the cell from its other end, rise.x first, negated, as is a boundary below θ0; versines are turned
// round; inputs that are not finite: 0.
#include "integral/fit/alpha.glsl"
#include "integral/fit/beta.glsl"
#include "integral/guard.glslh"
#include "integral/printed/cell.glslh"
#include "integral/sinc/a.glsl"
#include "integral/sinc/b.glsl"

float integral_sinc_radiance(float phi, float half_width, float theta0, vec2 rise, vec3 n, vec3 p, float lambda, float mu,
                             vec2 versines) {
    if (!(is_finite(vec3(phi, half_width, theta0)) && is_finite(rise) && is_finite(n) && is_finite(p) &&
          is_finite(vec2(lambda, mu)) && is_finite(versines)))
        return 0.0;
    PrintedCell cell = printed_cell(phi, half_width, theta0, rise, versines);
    if (half_width == 0.0) return 0.0;
    Lobe lobe = lobe_on(versines, lambda, mu);
    float beta = fit_beta(lobe, lambda), alpha = fit_alpha(lobe, beta, versines);
    return bounded(alpha * sinc_a(cell.phi0, cell.phi1, theta0, cell.k, cell.b, n) +
                   beta * sinc_b(cell.phi0, cell.phi1, theta0, cell.k, cell.b, n, unit_vector(p)));
}
