// The integral of cos²θ sinθ over φ0 … φ1 and θ0 … kφ + b: exact in θ, by Gauss–Legendre with 12 nodes in φ.
// [Appendix B, Equation 15, B3; docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0 (an angle of which no sine is known is 0, and so
// is its moment; times an infinite width it is NaN, which is 0 too), or the largest float if they overflow.
#include "integral/exact_theta/sum.glslh"
#include "integral/guard.glslh"

float integral_exact_theta_b3(float phi0, float phi1, float theta0, float k, float b) {
    vec2 from = turn(theta0);
    float sum = 0.0;
    for (int i = 0; i < GAUSS_12.pairs; ++i)
        for (int side = -1; side <= 1; side += 2) {
            vec2 node = GAUSS[GAUSS_12.first + i] * vec2(side, 1.0);
            Column column = column_at(phi0, phi1, theta0, k, b, from, node);
            sum += column.weight * column.moments.scc;
        }
    return bounded(sum);
}
