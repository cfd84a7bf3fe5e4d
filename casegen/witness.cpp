#include "casegen/witness.h"

#include <array>

namespace gnomon {

std::optional<Witness> smallest_witness(const Case& c, int most_texels) {
    for (int texels = 1; texels <= most_texels; ++texels)
        for (int width = 1; width <= texels; ++width) {
            if (texels % width != 0) continue;
            for (const Outside outside : {Outside::lit, Outside::shadow, Outside::clamp})
                for (std::uint32_t bits = 0; bits < (1u << texels); ++bits) {
                    Mask mask(width, texels / width, true, outside);
                    for (int i = 0; i < texels; ++i)
                        mask.texels[static_cast<std::size_t>(i)] = (bits >> i) & 1u;
                    for (int i = 0; i < texels; ++i) {
                        const glm::ivec2 texel(i % width, i / width);
                        if (applies(c, reference::edge(mask, texel))) return Witness{std::move(mask), texel};
                    }
                }
        }
    return {};
}

} // namespace gnomon
