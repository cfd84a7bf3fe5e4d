#include "casegen/reference/rsmss.h"

#include "casegen/reference/mask_runs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gnomon::reference {
namespace {

using glm::dvec2;
using glm::ivec2;

double unit(double v) { return std::clamp(v, 0.0, 1.0); }

/// Where along a run with one end, 0 at its beginning and 1 at its end.
double position(const Run& run, double x, unsigned options) {
    double reach = run.last - run.first;
    if ((options & long_runs) == 0) reach = std::min<double>(reach, longest_walk);
    const double from_end = run.closed_last ? run.last - x : x - run.first;
    return unit(1 - from_end / reach);
}

/// Light beside the shadow above (or below) row y: half of it on the line that leads from the middle of the
/// shadow's row, where the run begins, to the middle of the lit row, where it ends; one texel from dark to
/// light.
double ramp(const Run& run, int y, bool above, dvec2 point, unsigned options) {
    if (run.open()) return 1;
    const double lit_row = y + 0.5, dark_row = above ? y + 1.5 : y - 0.5;
    const double t = run.closed() ? 1 : position(run, point.x, options);
    const double line = (1 - t) * dark_row + t * lit_row;
    return unit(0.5 + (above ? line - point.y : point.y - line));
}

/// A texel between shadow below and shadow above, in a view where it is lit.
struct Slot {
    const View& view;
    int x, y;
    dvec2 point;
    unsigned options;

    double from_wall(bool above) const { return above ? y + 1 - point.y : point.y - y; }
    bool shut(int way) const { return !view.lit(x + way, y); }
    bool has_end() const { return shut(-1) || shut(+1); }
    double from_end() const { return shut(+1) ? x + 1 - point.x : point.x - x; }
    Across walls_next(int way) const { return shadow_across(view, x + way, y); }

    /// Which walls are left at the nearest texel, following the ways that are not shut here, that has not
    /// both; `all` of them where it could be either, nothing if there is none.
    std::optional<Across> breach() const {
        bool follow[2] = {!shut(-1), !shut(+1)};
        for (int k = 1; k <= longest_walk; ++k) {
            std::optional<Across> found;
            for (const int way : {-1, +1}) {
                bool& going = follow[way > 0 ? 1 : 0];
                going = going && view.lit(x + way * k, y);
                if (!going) continue;
                const Across walls = shadow_across(view, x + way * k, y);
                if (walls.all()) continue;
                if (found && found->any() && walls.any())
                    found = Across{found->below || walls.below, found->above || walls.above};
                else if (!found || !walls.any())
                    found = walls;
            }
            if (found) return found;
        }
        return {};
    }

    /// By the ramps of the walls that are left: the lighter of two, or as the options say.
    double by_walls(Across walls, double below, double above) const {
        if (walls.all()) {
            if ((options & first_breach) != 0) return below;
            return (options & opposite_breach) != 0 ? std::min(below, above) : std::max(below, above);
        }
        return walls.above ? above : below;
    }

    /// Shadow at both ends: lit only next to where a wall is missing, up to the diagonal.
    double closed_slot(const Run& run) const {
        double lightest = 0;
        bool opens = false;
        for (const int way : {+1, -1}) {
            const Across walls = walls_next(way);
            if (shut(way) || walls.all() || !walls.any()) continue;
            const double from_far_border = way > 0 ? point.x - x : x + 1 - point.x;
            const double value = from_wall(walls.above) + from_far_border - 1;
            if (!opens || (options & first_opening) == 0) lightest = std::max(lightest, value);
            opens = true;
        }
        if (!opens && has_end() && (options & printed_end) != 0) {
            const double nearer = std::min(point.x - run.first, run.last - point.x);
            const double along = unit(nearer / std::min<double>(run.last - run.first, longest_walk));
            lightest = std::min({from_wall(false) + 1 - along, from_wall(true) + 1 - along, from_end()});
        }
        return unit(lightest);
    }

    /// Light comes in by one end.
    double passage(const Run& run) const {
        const double fading = 1 - position(run, point.x, options);
        const std::optional<Across> walls = breach();
        if (!walls || !walls->any()) return fading;
        const double value = by_walls(*walls, from_wall(false) + fading, from_wall(true) + fading);
        return unit(has_end() ? std::min(value, from_end()) : value);
    }

    double lit_value(const Run& run) const {
        if (run.open()) return 1;
        return run.closed() ? closed_slot(run) : passage(run);
    }

    /// What was taken for light is shadow: how much light the bar gets. Mostly what the slot loses.
    double bar_value(const Run& run) const {
        if (run.open()) return 0;
        const double into_end = has_end() ? 1 - from_end() : 0;
        const Across next = has_end() ? walls_next(shut(+1) ? -1 : +1) : Across{true, true};
        const bool far = next.all();
        const auto across = [&](Across walls) { // over the bar's whole width, from the wall that goes on
            return std::max(into_end, 1 - by_walls(walls, from_wall(false), from_wall(true)));
        };
        if (run.closed()) {
            if (!far) return across(next);
            if (const std::optional<Across> walls = breach()) return across(*walls);
            if ((options & ramped_bar) == 0) return 0;
            return std::max({into_end, from_wall(false), from_wall(true)});
        }
        if (has_end() && far && (options & breach_by_position) == 0)
            if (const std::optional<Across> walls = breach(); walls && walls->any()) return across(*walls);
        return 1 - passage(run);
    }
};

/// A texel with one shadowed side on each axis, in a view where it is lit.
double corner_value(const View& view, int x, int y, Across rows, Across columns, dvec2 point,
                    unsigned options) {
    const View turned = view.turn();
    const int away_y = rows.above ? y - 1 : y + 1, away_x = columns.above ? x - 1 : x + 1;
    const bool column_edge_goes_on = shadow_across(turned, away_y, x).any();
    const bool row_edge_goes_on = shadow_across(view, away_x, y).any();
    if (!column_edge_goes_on &&
        !row_edge_goes_on) { // a lone step: steps from the grid point where shadow meets
        const dvec2 meeting(x + (columns.above ? 1 : 0), y + (rows.above ? 1 : 0));
        return unit(std::abs(point.x - meeting.x) + std::abs(point.y - meeting.y));
    }
    double light = 1;
    if (row_edge_goes_on) light = std::min(light, ramp(find_run(view, x, y), y, rows.above, point, options));
    if (column_edge_goes_on)
        light = std::min(light, ramp(find_run(turned, y, x), x, columns.above, {point.y, point.x}, options));
    return light;
}

} // namespace

double rsmss_visibility_in_mask_space(const Mask& mask, ivec2 texel, dvec2 p, unsigned options) {
    const int x = texel.x, y = texel.y;
    const dvec2 point = dvec2(texel) + p;
    const bool lit = mask.lit(x, y);
    const View view{mask, false, !lit}, turned = view.turn(); // in it the texel is lit
    const Across rows = shadow_across(view, x, y), columns = shadow_across(turned, y, x);
    const auto as_seen = [&](double light) { return lit ? light : 1 - light; };
    const auto slot = [&](const View& along, int sx, int sy, dvec2 at) {
        const Slot s{along, sx, sy, at, options};
        const Run run = find_run(along, sx, sy);
        return lit ? s.lit_value(run) : s.bar_value(run);
    };
    if (rows.all() && columns.all()) return as_seen(0);
    if (rows.all()) return slot(view, x, y, point);
    if (columns.all()) return slot(turned, y, x, {point.y, point.x});
    if (rows.any() && columns.any()) return as_seen(corner_value(view, x, y, rows, columns, point, options));
    if (rows.any()) return as_seen(ramp(find_run(view, x, y), y, rows.above, point, options));
    if (columns.any())
        return as_seen(ramp(find_run(turned, y, x), x, columns.above, {point.y, point.x}, options));
    return as_seen(1);
}

} // namespace gnomon::reference
