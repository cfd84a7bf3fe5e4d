// Masks that tests go through one by one.
#pragma once

#include "casegen/mask_families.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gnomon::testing {

/// The side-by-side mask whose texels are the bits of `bits`, 1 lit.
inline Mask mask_of_bits(std::uint32_t bits, int side, Outside outside) {
    Mask mask(side, side, true, outside);
    for (std::uint8_t& texel : mask.texels) {
        texel = bits & 1u;
        bits >>= 1;
    }
    return mask;
}

/// All 2^16 masks of 4 x 4 texels in one surround.
template <typename Visit>
void for_all_4x4_masks(Outside outside, const Visit& visit) {
    for (std::uint32_t bits = 0; bits < 1u << 16; ++bits) visit(mask_of_bits(bits, 4, outside));
}

template <typename Visit>
void for_lit_texels(const Mask& mask, const Visit& visit) {
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if (mask.lit(x, y)) visit(glm::ivec2(x, y));
}

} // namespace gnomon::testing
