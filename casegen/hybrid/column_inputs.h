// What the kernels of kernels/column are tried on besides triangles: where margins, borders and roundings
// decide. Words as in the parameters of casegen/column.cpp.
#pragma once

#include "casegen/kernel_case.h"

#include <memory>

namespace gnomon::hybrid {

/// Three corners, a square's middle, half its side: tips of needles too.
std::shared_ptr<const Generator> triangles_and_squares();
/// Three corners, a point, a margin.
std::shared_ptr<const Generator> triangles_and_points();
/// Two points of a line, two beside it, a margin.
std::shared_ptr<const Generator> lines_and_points();
/// Three corners with depths, where a ray begins, its least length, margins across the light and in depth.
std::shared_ptr<const Generator> triangles_and_rays();
/// Three corners with depths, a square's middle, half its side, a margin.
std::shared_ptr<const Generator> planes();
/// A segment's ends, a square's middle, half its side.
std::shared_ptr<const Generator> segments();

} // namespace gnomon::hybrid
