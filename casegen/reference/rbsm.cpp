#include "casegen/reference/rbsm.h"

#include <algorithm>

namespace gnomon::reference {
namespace {

/// nrd.xy: how far the point is from the end, as part of the run; 0 where the run has no end.
glm::dvec2 from_end(const Edge& edge, glm::dvec2 p) {
    const auto one = [](glm::ivec2 reach, double c) {
        return edge_type(reach) == 0 ? 1 - along(reach, c) : 0;
    };
    return {one({edge.reach.x, edge.reach.y}, p.x), one({edge.reach.z, edge.reach.w}, p.y)};
}

} // namespace

double rbsm_silhouette(const Edge& edge, glm::dvec2 p) {
    if (edge.sides.x == both || edge.sides.y == both) return 0; // short U and O
    if (edge.type.x == 1 || edge.type.y == 1) return 0;         // long U and O
    if (edge.type.x == -1 || edge.type.y == -1) return 1;       // I
    const glm::dvec2 nrd = from_end(edge, p);
    return nrd.y < 1 - nrd.x ? 0 : 1; // L: step(1 - x, y)
}

double rbsm_filter(const Edge& edge, glm::dvec2 p, bool open_first) {
    const double test = edge.lit ? 0 : 1, sign = 1 - 2 * test; // d.z: 1 in shadow
    const bool is_open = edge.type.x == -1 || edge.type.y == -1;
    const glm::dvec2 nrd = from_end(edge, p);
    if (edge.sides.x == both && edge.sides.y == both) return test; // short O
    if (edge.type.x == 1 && edge.type.y == 1) return test;         // long O
    if (open_first && is_open) return 1 - test;
    if (edge.type.x == 1) return test + sign * nrd.y; // U
    if (edge.type.y == 1) return test + sign * nrd.x;
    if (is_open) return 1 - test;                               // I
    return std::clamp(test + sign * (nrd.y + nrd.x), 0.0, 1.0); // L
}

} // namespace gnomon::reference
