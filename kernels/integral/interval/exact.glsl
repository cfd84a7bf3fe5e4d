// The interval (a, b) that the dot product with p̂ = p/|p| takes over a cell. For each φ it is a wave in θ, whose
// amplitude p_x cosφ + p_y sinφ is a wave in φ; sinθ is nowhere negative, so a larger amplitude never gives a smaller
// product: the extremes over φ first, then over θ.   [docs/integrals.md, section 5]
// Continuous when the axis crosses a cell's edge, which the four corners are not. Inputs that are not finite: the whole
// interval (-1, 1).
#include "integral/trigonometry.glslh"
#include "integral/guard.glslh"
#include "integral/interval/arc.glslh"

vec2 integral_interval_exact(float phi, float half_width, vec2 theta, vec3 p) {
    if (!(is_finite(phi) && is_finite(half_width) && is_finite(theta) && is_finite(p))) return vec2(-1.0, 1.0);
    if (p == vec3(0.0)) return vec2(0.0);
    p = unit_vector(p);
    Arcs arcs = arcs_of(phi, half_width, theta);
    float c = p.x * arcs.middle.x + p.y * arcs.middle.y, s = p.y * arcs.middle.x - p.x * arcs.middle.y;
    float high = arc_highest(c, s, arcs.ends), low = arc_lowest(c, s, arcs.ends);
    vec2 t = arcs.middle_t;
    float a = arc_lowest(low * t.y + p.z * t.x, low * t.x - p.z * t.y, arcs.ends_t);
    float b = arc_highest(high * t.y + p.z * t.x, high * t.x - p.z * t.y, arcs.ends_t);
    return clamp(vec2(a, b), -1.0, 1.0);
}
