// When a case applies, as data: what a decision list asks of a texel, once for people and once for kernels.
// The decision list's reference, the assembled kernels, `describe` and the atlas all read it.
#pragma once

#include "casegen/reference/revectorize.h"

#include <string>
#include <vector>

namespace gnomon {

/// A conjunction. Each member is a set of allowed values, one bit per value; the default allows all of them.
struct Condition {
    unsigned light = 3;     ///< of shadowed (1), lit (2)
    unsigned side_x = 15;   ///< of neither (1), minus (2), plus (4), both (8): sides that differ along x
    unsigned side_y = 15;   ///< the same along y
    unsigned type_x = 7;    ///< of open (1), one end (2), closed (4): the run along x
    unsigned type_y = 7;    ///< the same along y
    unsigned dominant = 15; ///< of neither (1), x (2), y (4), both (8): edges that go on beyond a corner
};

/// Names for the sets.
namespace sets {
constexpr unsigned shadowed = 1, lit = 2;
constexpr unsigned neither = 1, minus = 2, plus = 4, both = 8, one = minus | plus, some = one | both,
                   any_side = neither | some;
constexpr unsigned open = 1, one_end = 2, closed = 4, any_type = 7;
constexpr unsigned goes_on_x = 2, goes_on_y = 4, goes_on_both = 8, ends_both = 1, any_dominance = 15;
} // namespace sets

/// An edge on one axis only: a run along x beside shadow (or light) on its y sides, or along y.
inline Condition run_along_x(unsigned light, unsigned side_y, unsigned type_x) {
    return {.light = light, .side_x = sets::neither, .side_y = side_y, .type_x = type_x};
}
inline Condition run_along_y(unsigned light, unsigned side_x, unsigned type_y) {
    return {.light = light, .side_x = side_x, .side_y = sets::neither, .type_y = type_y};
}
/// One side on each axis.
inline Condition corner(unsigned light, unsigned side_x, unsigned side_y, unsigned type_x, unsigned type_y,
                        unsigned dominant) {
    return {light, side_x, side_y, type_x, type_y, dominant};
}

/// Holds where any of its conjunctions does.
using Conditions = std::vector<Condition>;

bool holds(const Condition& condition, const reference::Edge& edge);
bool holds(const Conditions& conditions, const reference::Edge& edge);

/// A GLSL expression over `Edge edge` (kernels/revectorize/edge.glslh): "edge.lit && edge.sides.x == NEITHER
/// && …"; what every edge satisfies by its other members is asked for too.
std::string to_glsl(const Conditions& conditions);

/// "a lit texel with shadow towards +y and none along x; the run along x ends once". A run is open if it ends
/// nowhere. Conjunctions are parted by "; or ".
std::string in_words(const Condition& condition);
std::string in_words(const Conditions& conditions);

} // namespace gnomon
