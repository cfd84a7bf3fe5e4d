#include "casegen/reference/mask_space.h"

#include "casegen/reference/mask_runs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon::reference {
namespace {

using glm::dvec2;
using glm::ivec2;

/// Twice the signed area of the triangle a, b, c.
double cross(dvec2 a, dvec2 b, dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Whether `point` and `witness` lie strictly on the same side of the line through a and b.
bool same_side(dvec2 a, dvec2 b, dvec2 point, dvec2 witness) {
    const double side = cross(a, b, point);
    return side != 0 && (side > 0) == (cross(a, b, witness) > 0);
}

/// Dark by the line of a run with exactly one end.
bool behind_line(const Run& run, int y, dvec2 point) {
    const double near = run.side.above ? y + 1 : y, far = run.side.above ? y : y + 1;
    const double reach = std::min<double>(run.last - run.first, longest_walk);
    const dvec2 end(run.closed_last ? run.last : run.first, far);
    const dvec2 beginning(run.closed_last ? end.x - reach : end.x + reach, near);
    if (std::abs(point.x - end.x) > reach) return false; // beyond the beginning nothing is added
    return same_side(end, beginning, point, {end.x, near});
}

} // namespace

double smsr_visibility_in_mask_space(const Mask& mask, ivec2 texel, dvec2 p) {
    if (!mask.lit(texel.x, texel.y)) return 0;
    const View upright{mask}, turned{mask, true};
    const Run along_x = find_run(upright, texel.x, texel.y), along_y = find_run(turned, texel.y, texel.x);
    const dvec2 point = dvec2(texel) + p;
    const auto dark_x = [&] { return behind_line(along_x, texel.y, point); };
    const auto dark_y = [&] { return behind_line(along_y, texel.x, {point.y, point.x}); };

    const auto single_edge = [](const Run& run, const auto& dark) -> double {
        if (!run.closed_first && !run.closed_last) return 1;
        if (run.closed_first && run.closed_last) return 0;
        return run.side.all() || dark() ? 0 : 1;
    };
    if (!along_x.side.any() && !along_y.side.any()) return 1;
    if (!along_y.side.any()) return single_edge(along_x, dark_x);
    if (!along_x.side.any()) return single_edge(along_y, dark_y);

    // A corner. Shadow on three sides, or a run that ends at both, closes it.
    const auto closed = [](const Run& run) {
        return run.side.all() || (run.closed_first && run.closed_last);
    };
    if (closed(along_x) || closed(along_y)) return 0;
    const int away_y = along_x.side.above ? texel.y - 1 : texel.y + 1;
    const int away_x = along_y.side.above ? texel.x - 1 : texel.x + 1;
    const bool y_edge_goes_on = shadow_across(turned, away_y, texel.x).any();
    const bool x_edge_goes_on = shadow_across(upright, away_x, texel.y).any();
    if (x_edge_goes_on || y_edge_goes_on)
        return (x_edge_goes_on && dark_x()) || (y_edge_goes_on && dark_y()) ? 0 : 1;
    // A lone step: the texel's diagonal, dark towards the corner where its two shadowed sides meet.
    const dvec2 corner(texel.x + (along_y.side.above ? 1 : 0), texel.y + (along_x.side.above ? 1 : 0));
    const dvec2 opposite = 2.0 * (dvec2(texel) + 0.5) - corner;
    return same_side({corner.x, opposite.y}, {opposite.x, corner.y}, point, corner) ? 0 : 1;
}

} // namespace gnomon::reference
