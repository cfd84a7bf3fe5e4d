// What the kernels of kernels/conservative are tried on besides triangles. Words as in the parameters of
// casegen/conservative.cpp.
#pragma once

#include "casegen/kernel_case.h"

#include <memory>

namespace gnomon::hybrid {

/// Triangles with depths about a level and spread a little or much; points in needles and at corners, texels
/// of all sizes: each term of the sum for a depth is the largest somewhere. `name` is the seed too.
std::shared_ptr<const Generator> depths_in_triangles(const char* name, bool over_texels);

/// Two lines, parallel or nearly so too.
std::shared_ptr<const Generator> pairs_of_lines();

/// Unit normals all round, and texels of every size.
std::shared_ptr<const Generator> normals_and_texels();

/// Points and boxes on a coarse grid: on borders and corners as often as beside them.
std::shared_ptr<const Generator> points_and_boxes();

} // namespace gnomon::hybrid
