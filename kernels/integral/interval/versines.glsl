// The versines (1 - a, 1 - b) of the interval that the dot product with p̂ = p/|p| takes over a cell: half the squared
// distances of the unit sphere's farthest and nearest point from p̂, so that they keep their digits where the lobe's
// axis is close.   [docs/integrals.md, sections 4 and 5]
// Inputs that are not finite: the whole interval, (2, 0).
#include "integral/trigonometry.glslh"
#include "integral/guard.glslh"
#include "integral/interval/arc.glslh"

// The point of an arc, (cos, sin) from its middle, where c cos t + s sin t is highest.
vec2 highest_point(float c, float s, vec2 ends) {
    float peak = length(vec2(c, s));
    if (peak < 1e-18) return vec2(1.0, 0.0); // the squares are none: any point is as good
    return arc_holds(c, s, peak, ends) ? vec2(c, s) / peak : vec2(ends.x, s < 0.0 ? -ends.y : ends.y);
}

// Half the squared distance from p to the cell's point that `sign` p is nearest to.
float versine_at(vec3 p, float sign, vec2 ends, vec2 first, vec2 last, vec2 middle, vec2 ends_t) {
    vec2 across = highest_point(sign * p.x, sign * p.y, ends);
    float amplitude = p.x * across.x + p.y * across.y;
    float c = sign * (amplitude * middle.y + p.z * middle.x), s = sign * (amplitude * middle.x - p.z * middle.y);
    float peak = length(vec2(c, s));
    // At an end of θ its own sine is taken, not the middle's turned: near a pole that keeps its digits.
    vec2 t = s < 0.0 ? first : last;
    // (Below 1e-18 the squares are none: the product is then 0 all over the arc.)
    if (peak > 1e-18 && arc_holds(c, s, peak, ends_t)) t = sign * vec2(p.z, amplitude) / peak;
    vec3 away = vec3(t.y * across, t.x) - p;
    return 0.5 * dot(away, away);
}

vec2 integral_interval_versines(float phi, float half_width, vec2 theta, vec3 p) {
    if (!(is_finite(phi) && is_finite(half_width) && is_finite(theta) && is_finite(p))) return vec2(2.0, 0.0);
    if (p == vec3(0.0)) return vec2(1.0);
    p = unit_vector(p);
    if (theta.y < theta.x) theta = theta.yx;
    Arcs arcs = arcs_of(phi, half_width, theta);
    vec3 turned = vec3(p.x * arcs.middle.x + p.y * arcs.middle.y, p.y * arcs.middle.x - p.x * arcs.middle.y, p.z);
    vec2 first = turn(theta.x), last = turn(theta.y);
    return clamp(vec2(versine_at(turned, -1.0, arcs.ends, first, last, arcs.middle_t, arcs.ends_t),
                      versine_at(turned, 1.0, arcs.ends, first, last, arcs.middle_t, arcs.ends_t)),
                 0.0, 2.0);
}
