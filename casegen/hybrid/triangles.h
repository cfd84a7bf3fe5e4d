// Triangles, distances and points to try the hybrid kernels on: of any size from 1e-6 to 1e6, near the origin
// and far from it, fair and all but flat, wound either way.
#pragma once

#include "casegen/kernel_case.h"

#include <memory>

namespace gnomon::hybrid {

constexpr double farthest = 1e6; ///< of every coordinate

/// The words of a kernel: a triangle's corners, x and y each at `first`, `first` + `stride`, …; a distance in
/// the triangle's unit at `distance`, and points near the triangle at `points`.
struct Layout {
    std::size_t stride = 2;
    std::ptrdiff_t distance = -1; ///< -1: there is none
    std::vector<std::size_t> points{};
    std::vector<std::size_t> extents{};                     ///< small positive lengths
    std::vector<std::pair<std::size_t, unsigned>> counts{}; ///< whole numbers: where, and the largest
    std::vector<std::size_t> depths{};                      ///< numbers of the order of 1
    std::vector<unsigned> choices_away{}; ///< which of 0 … 7 the first of `counts` may be; empty: any
};

/// `name` is the seed too.
std::shared_ptr<const Generator> triangles(const char* name, const Layout& layout);

/// The same for what is left between lit and shadowed neighbours, with as many distances from each interval
/// between those at which edges are lost, cuts meet or nothing is left.
std::shared_ptr<const Generator> shrunken_triangles(const char* name, const Layout& layout);

} // namespace gnomon::hybrid
