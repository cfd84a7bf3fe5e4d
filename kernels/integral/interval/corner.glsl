// The interval (a, b) of the dot product with p̂ over a cell as Appendix A has it: the least and greatest at the four
// corners, b = 1 if the axis lies in the cell, a = -1 if its opposite does. It is no bound: an edge can reach further
// than its corners.   [Appendix A; docs/integrals.md, section 5]
#include "integral/trigonometry.glslh"
#include "integral/guard.glslh"
#include "integral/interval/arc.glslh"

vec2 integral_interval_corner(float phi, float half_width, vec2 theta, vec3 p) {
    if (!(is_finite(phi) && is_finite(half_width) && is_finite(theta) && is_finite(p))) return vec2(-1.0, 1.0);
    if (p == vec3(0.0)) return vec2(0.0);
    p = unit_vector(p);
    Arcs arcs = arcs_of(phi, half_width, theta);
    float c = p.x * arcs.middle.x + p.y * arcs.middle.y, s = p.y * arcs.middle.x - p.x * arcs.middle.y;
    vec2 amplitudes = c * arcs.ends.x + vec2(s, -s) * arcs.ends.y;
    vec2 first = turn(theta.x), last = turn(theta.y);
    vec4 corners = vec4(amplitudes * first.y + p.z * first.x, amplitudes * last.y + p.z * last.x);
    float a = min(min(corners.x, corners.y), min(corners.z, corners.w));
    float b = max(max(corners.x, corners.y), max(corners.z, corners.w));
    // An axis is in the cell if its direction is in both arcs.
    float u = length(p.xy), high = u, low = -u;
    vec2 t = arcs.middle_t;
    bool in_phi = arc_holds(c, s, u, arcs.ends), opposite_in_phi = arc_holds(-c, -s, u, arcs.ends);
    if (in_phi && arc_holds(high * t.y + p.z * t.x, high * t.x - p.z * t.y, 1.0, arcs.ends_t)) b = 1.0;
    if (opposite_in_phi && arc_holds(-(low * t.y + p.z * t.x), p.z * t.y - low * t.x, 1.0, arcs.ends_t)) a = -1.0;
    return clamp(vec2(a, b), -1.0, 1.0);
}
