// A second opinion on SMSR that shares neither formula nor decision list with the kernels: lines and sides in
// the plane of the mask, in texels.
#pragma once

#include "casegen/mask.h"

#include <glm/glm.hpp>

namespace gnomon::reference {

/// 0 if the point `texel` + `p` is in shadow after silhouette revectorisation, else 1. For each side on which
/// the lit texel meets shadow, the run of texels along that side is found, and the line drawn from the run's
/// end (the grid point where it meets shadow head-on, on the border away from the side) to its beginning (on
/// the side itself); the point is dark if it lies strictly on the line's shadow side.
/// docs/revectorization.md, 2.3.
double smsr_visibility_in_mask_space(const Mask& mask, glm::ivec2 texel, glm::dvec2 p);

} // namespace gnomon::reference
