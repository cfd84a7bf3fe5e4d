// What the kernels of kernels/column are judged by: polygons clipped by squares, boxes whose corners are all
// tried, planes as the inverse of three points' matrix. In double, or in multiprecision where the answer is
// no yes or no.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/reference/hybrid/lines.h"

namespace gnomon::reference::hybrid {

using Place = Point<double>;

/// Whether a triangle, also one that is a segment or a point, meets the closed square round `centre`.
bool meets_square(const Triangle<double>& triangle, Place centre, double half_side);
/// The same of a segment.
bool segment_meets_square(Place a, Place b, Place centre, double half_side);

/// Whether c and d are on opposite sides of ab wherever the four are within squares of half side `margin`
/// round them: a side is linear in every coordinate, so the squares' corners say so.
bool are_opposite(Place a, Place b, Place c, Place d, double margin);

/// 8 if the square of half side 2 `margin` round p does not meet the triangle, else the bits of the edges
/// that have a corner of it on their outer side.
unsigned coverage(const Triangle<double>& triangle, Place p, double margin);
/// Whether who is wrong by `rounding` in every coordinate must answer the same.
bool is_clear_coverage(const Triangle<double>& triangle, Place p, double margin, double rounding);

/// A triangle with depth: x, y, z of its corners.
using Solid = std::array<std::array<double, 3>, 3>;

/// 0: nowhere nearer than `end`; 1: nearer; 2 unsure, by the plane at (x, y) and what it may be wrong by:
/// that, and as much again as coordinates wrong by `rounding` make it (negative: less), for clear answers.
unsigned height(const Solid& solid, Place at, double end, double margin, double margin_z,
                double rounding = 0);

/// Whether a plane through the corners is known: 1 yes, 0 no, 2 too near to say for who rounds.
unsigned has_plane(const Solid& solid, double margin);

Truth column_plane(const Arguments& a_b_c_at_half_side_margin);
Truth column_depth_bounds(const Arguments& a_b_c_centre_half_side_margin);

} // namespace gnomon::reference::hybrid
