// What sound techniques are certain of, against exact rays.
#pragma once

#include "runtime/pipeline/renderer.h"

#include <string>
#include <vector>

namespace gnomon::hybrid {

/// One technique in one view.
struct Certainty {
    std::string technique;
    std::size_t facing = 0, lit = 0, shadowed = 0;     ///< pixels: that face the light; certain ones
    std::size_t lit_wrongly = 0, shadowed_wrongly = 0; ///< certain ones that an exact ray contradicts
    std::string first;                                 ///< the first of them, in words
    std::size_t wrong() const { return lit_wrongly + shadowed_wrongly; }
};

/// Every sound technique but `traced`, which is certain of nothing.
std::vector<std::string> sound_techniques();

/// The rays that the tracer would trace, met or not, for the pixels that face the light. By
/// pixel; 1: lit.
std::vector<std::uint8_t> exact_visibility(Renderer& renderer, const Scene& scene, const Camera& camera,
                                           const Light& light, const ViewSettings& settings);

std::vector<Certainty> certainties(Renderer& renderer, const std::vector<std::uint8_t>& exact,
                                   const std::vector<std::string>& techniques);

} // namespace gnomon::hybrid
