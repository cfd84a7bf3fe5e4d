// Every hybrid technique there is.
#include "runtime/hybrid/classifier.h"
#include "runtime/hybrid/make.h"

#include <algorithm>

namespace gnomon {

const std::vector<HybridTechnique>& hybrid_techniques() {
    static const std::vector<HybridTechnique> all{
        {"traced", "certain of nothing: a ray for every pixel that faces the light", true, make_nothing},
        {"sheet", "depths alone: sheets of triangles that cover a texel, bounds of those that reach into it",
         true, make_sheet},
        {"nearest-8", "sheet, and the ray against the eight triangles nearest to the light", true,
         make_nearest},
        {"lists", "the ray against every triangle of its texel's list", true, make_lists},
        {"beister", "one map; certain where its four diagonal taps agree", false, make_beister},
        {"bilinear", "one map; certain where its bilinear footprint agrees", false, make_bilinear},
        {"crsm", "maps of grown and of shrunken triangles that face away", false, make_crsm},
        {"crsma", "crsm, shrunken towards lit neighbours only, by a geometry shader", false, make_crsma},
        {"crsma-one-ring", "crsma, cut only at vertices that a lit face touches; no geometry shader", false,
         make_crsma_one_ring},
    };
    return all;
}

const HybridTechnique* find_hybrid(const std::string& name) {
    const auto found = std::ranges::find(hybrid_techniques(), name, &HybridTechnique::name);
    return found == hybrid_techniques().end() ? nullptr : &*found;
}

} // namespace gnomon
