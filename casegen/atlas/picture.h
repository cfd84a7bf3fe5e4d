// A witness drawn as SVG: its texels, what surrounds them, and where the tested texel's edge is.
#pragma once

#include "casegen/witness.h"

#include <string>

namespace gnomon::atlas {

inline constexpr int texel_pixels = 40; ///< the side of a texel in pictures
inline constexpr int way_pixels = 20;   ///< and in those of the ways through a case

/// The mask with one ring of its surround (hatched); the tested texel outlined, and an arrow across each of
/// its sides on which the neighbour's shadow test differs. y grows downwards. Colours are the page's classes;
/// `alternative` says the same in words.
std::string witness_svg(const Witness& witness, const std::string& alternative, int pixels = texel_pixels);

/// Lines between the texels of the same picture, and the tested texel's outline: to lie over another one.
std::string grid_svg(const Witness& witness);

/// "texel 1,0 of 2 × 2 texels, surround lit; shadow: (0,1) (1,1)": what the picture shows.
std::string witness_words(const Witness& witness);

} // namespace gnomon::atlas
