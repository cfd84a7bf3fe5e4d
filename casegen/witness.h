// The smallest mask that leads to a case: its picture, its proof that it can happen, and a test's input.
#pragma once

#include "casegen/kernel_case.h"

#include <optional>

namespace gnomon {

struct Witness {
    Mask mask;
    glm::ivec2 texel{0};
};

/// Searches all masks in order of their texel count (then width), all surrounds (lit, shadow, clamp), all
/// texels; the first at which the case applies. Nothing if none of at most `most_texels` does. The case must
/// have a condition.
std::optional<Witness> smallest_witness(const Case& c, int most_texels = 12);

} // namespace gnomon
