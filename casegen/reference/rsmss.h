// RSMSS's readings, and a second opinion on it that shares neither formula nor decision list with the
// kernels: lines, distances and symmetries in the plane of the mask.
#pragma once

#include "casegen/mask.h"

#include <glm/glm.hpp>

namespace gnomon::reference {

/// The bits of kernels/rsmss/options.glslh; docs/decisions.md says what each stands for.
enum RsmssOption : unsigned {
    printed_end = 1,
    first_opening = 2,
    first_breach = 4,
    opposite_breach = 8,
    ramped_bar = 16,
    long_runs = 32,
    breach_by_position = 64,
};

/// Light at the point `texel` + `p` after filtering revectorisation, 0 to 1. One of the eight views of an
/// edge is solved, the others follow by exchanging x with y, and light with shadow; the light beside an edge
/// is the distance, across the run, from the line between the middles of the rows that meet there.
/// docs/revectorization.md, 4.3.
double rsmss_visibility_in_mask_space(const Mask& mask, glm::ivec2 texel, glm::dvec2 p, unsigned options);

} // namespace gnomon::reference
