// Generators of shadow masks: the shapes that shadow edges take, from the ordinary to the vicious.
#pragma once

#include "casegen/mask.h"
#include "casegen/random.h"

#include <string>
#include <vector>

namespace gnomon {

struct MaskFamily {
    std::string name;                       ///< "half-planes"
    std::string what;                       ///< one line
    Mask (*make)(Random& random, int size); ///< size x size texels; every draw another member
};

/// Half-planes at many slopes, circles, thin strips, segments, rectangles, shapes (I, U, L, O), combs, smooth
/// blobs, mazes, noise, single texels.
const std::vector<MaskFamily>& mask_families();

struct NamedMask {
    std::string name; ///< "half-planes/3"
    Mask mask;
};

/// `members` masks of every family, with every kind of surround in turn. The same seed gives the same bits.
std::vector<NamedMask> mask_corpus(std::uint64_t seed, int members, int size);

/// Shadow where a*x + b*y < c at the texel's centre.
Mask half_plane(int size, double a, double b, double c);

} // namespace gnomon
