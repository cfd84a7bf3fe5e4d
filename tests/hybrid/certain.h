// What sound techniques are certain of, against exact rays.
#pragma once

#include "runtime/hybrid/classifier.h"
#include "tests/hybrid/exact_ray.h"
#include "tests/pipeline/view.h"

#include <string>
#include <vector>

namespace gnomon::testing {

/// One technique in one view.
struct Certainty {
    std::string technique;
    std::size_t facing = 0, lit = 0, shadowed = 0; ///< pixels: that face the light; certain ones
    std::size_t wrong = 0;
    std::string first; ///< the first wrong one, in words
};

/// Every sound technique but `traced`, which is certain of nothing.
std::vector<std::string> sound_techniques();

/// The rays that the tracer would trace, met or not, for the pixels that face the light. `rays` and the
/// result go by pixel; 1: lit.
std::vector<std::uint8_t> exact_visibility(Renderer& renderer, const Scene& scene, const View& view);

std::vector<Certainty> certainties(Renderer& renderer, const std::vector<std::uint8_t>& exact,
                                   const std::vector<std::string>& techniques);

} // namespace gnomon::testing
