// A cell under the boundary θ = kφ + b in the form that keeps its digits: (φ in the middle, half the width, and how far
// the boundary lies above θ0 at φ0 and at φ1). The heights are rounded once: products and sums carry their errors along.
// [Appendix B, Equation 5; docs/integrals.md, section 3; Dekker 1971, Knuth]
// Inputs that are not finite: 0.
#include "integral/guard.glslh"

// (sum, error) and (product, error).
vec2 exact_sum(float x, float y) {
    precise float sum = x + y;
    precise float of_y = sum - x;
    precise float error = (x - (sum - of_y)) + (y - of_y);
    return vec2(sum, error);
}
vec2 exact_product(float x, float y) {
    float high = uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
    float high_y = uintBitsToFloat(floatBitsToUint(y) & 0xfffff000u);
    precise float low = x - high, low_y = y - high_y;
    precise float product = x * y;
    precise float error = ((high * high_y - product) + high * low_y + low * high_y) + low * low_y;
    return vec2(product, error);
}
// kφ + b - θ0: the exact terms added over and over, each sum's error kept in its place, until no more than one rounding
// is left (Ogita, Rump and Oishi 2005).
float height(float k, float phi, float b, float theta0) {
    vec2 product = exact_product(k, phi), above = exact_sum(b, -theta0);
    float terms[4] = float[](product.y, above.y, product.x, above.x);
    for (int pass = 0; pass < 3; ++pass)
        for (int i = 1; i < 4; ++i) {
            vec2 sum = exact_sum(terms[i], terms[i - 1]);
            terms[i] = sum.x;
            terms[i - 1] = sum.y;
        }
    precise float result = terms[3] + (terms[2] + (terms[1] + terms[0]));
    return result;
}

vec4 integral_cell_from_boundary(float phi0, float phi1, float theta0, float k, float b) {
    if (!(is_finite(vec3(phi0, phi1, theta0)) && is_finite(vec2(k, b)))) return vec4(0.0);
    precise vec2 middle_and_half = vec2(0.5 * phi0 + 0.5 * phi1, 0.5 * phi1 - 0.5 * phi0);
    vec2 heights = vec2(height(k, phi0, b, theta0), height(k, phi1, b, theta0));
    return vec4(bounded(middle_and_half), bounded(heights));
}
