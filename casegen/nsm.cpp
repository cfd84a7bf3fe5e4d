// The table of kernels/nsm: plain shadow mapping, what every other technique is compared with.
#include "casegen/catalogue.h"
#include "casegen/vocabulary.h"

namespace gnomon {

Family nsm_family() {
    return {"nsm",
            "plain shadow mapping: the nearest texel's shadow test",
            {{
                .name = "nsm/visibility",
                .source = "Williams 1978, Casting curved shadows on curved surfaces",
                .reference = [](const Mask& mask, glm::ivec2 texel,
                                glm::dvec2) { return mask.lit(texel.x, texel.y) ? 1.0 : 0.0; },
                .parameters = {vocabulary::texel(), vocabulary::p()},
                .result = {0, 1, "1", "1 lit, 0 shadowed"},
            }}};
}

} // namespace gnomon
