// Runs of texels beside an edge, found in the plane of the mask: what the references in mask space share.
// None of it is written as the kernels are.
#pragma once

#include "casegen/mask.h"
#include "casegen/reference/revectorize.h"

namespace gnomon::reference {

/// A view of the mask in which the run in question always lies along x, of texels that are called lit.
struct View {
    const Mask& mask;
    bool turned = false;   ///< x and y exchanged
    bool inverted = false; ///< light and shadow exchanged
    bool lit(int x, int y) const { return (turned ? mask.lit(y, x) : mask.lit(x, y)) != inverted; }
    View turn() const { return {mask, !turned, inverted}; }
};

/// Which of the two neighbours across the run are in shadow.
struct Across {
    bool below = false, above = false; ///< towards -y, +y
    bool any() const { return below || above; }
    bool all() const { return below && above; }
};

inline Across shadow_across(const View& view, int x, int y) {
    return {!view.lit(x, y - 1), !view.lit(x, y + 1)};
}

/// The run of lit texels along x through (x, y) beside shadow: grid lines where it stops, and whether it
/// stops at shadow.
struct Run {
    double first = 0, last = 0;
    bool closed_first = false, closed_last = false;
    Across side;
    bool closed() const { return closed_first && closed_last; }
    bool open() const { return !closed_first && !closed_last; }
};

inline Run find_run(const View& view, int x, int y) {
    Run run;
    run.side = shadow_across(view, x, y);
    const auto stop = [&](int direction, bool& closed) {
        int steps = 0;
        for (;;) {
            ++steps;
            const int next = x + direction * steps;
            closed = steps <= longest_walk && !view.lit(next, y);
            if (closed || steps > longest_walk) break;
            const Across there = shadow_across(view, next, y);
            if (!((run.side.below && there.below) || (run.side.above && there.above))) break;
        }
        return direction > 0 ? x + steps : x + 1 - steps; // the grid line before the texel that stopped it
    };
    run.last = stop(+1, run.closed_last);
    run.first = stop(-1, run.closed_first);
    return run;
}

} // namespace gnomon::reference
