// A rendering against the truth, pixel by pixel.
#pragma once

#include "runtime/image.h"
#include "runtime/pipeline/renderer.h"

#include <cstddef>
#include <span>

namespace gnomon {

/// Counts of pixels. "Wrong" is over those that face the light; visibility below a half is shadow.
struct PixelCounts {
    std::size_t all = 0, covered = 0;
    std::size_t facing = 0, facing_away = 0;       ///< of the covered
    std::size_t truly_lit = 0, truly_shadowed = 0; ///< of the facing, by truth
    std::size_t wrong_lit = 0, wrong_shadowed = 0; ///< lit where truth is shadow; shadowed where truth is lit
    double wrong_share() const {
        return facing == 0 ? 0
                           : static_cast<double>(wrong_lit + wrong_shadowed) / static_cast<double>(facing);
    }
};

PixelCounts count_pixels(const Surfaces& surfaces, std::span<const float> visibility,
                         std::span<const float> truth);

/// Pixels whose visibility is not the truth's, bit for bit. NaN is the same as nothing.
std::size_t count_differing(std::span<const float> visibility, std::span<const float> truth);

/// Light grey: lit and right; dark grey: shadow and right; red: lit where truth is shadow; blue: shadowed
/// where truth is lit; slate: faces away from the light; white: background.
Image false_colours(const Surfaces& surfaces, std::span<const float> visibility, std::span<const float> truth,
                    int width, int height);

} // namespace gnomon
