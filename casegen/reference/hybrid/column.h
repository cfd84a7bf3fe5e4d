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
/// round them: a side is linear in every coordinate, so the squares' corners say so. By more than what the
/// product of the distances from a is rounded by.
bool are_opposite(Place a, Place b, Place c, Place d, double margin);
/// Whether who rounds must answer the same. It may give up where the worst that moving any four points can do
/// would bring one to the line, though moving these four cannot.
bool is_clear_opposite(Place a, Place b, Place c, Place d, double margin);

/// 8 if the square of half side `off` round p does not meet the triangle, else the bits of the edges that
/// have a corner of it on their outer side; `off` is twice the margin, or eight roundings of the way to the
/// farthest corner.
unsigned coverage(const Triangle<double>& triangle, Place p, double margin);
/// Whether who rounds must answer the same: where coordinates wrong by `rounding` decide whether the square
/// is met, it need not.
bool is_clear_coverage(const Triangle<double>& triangle, Place p, double margin, double rounding);

/// A triangle with depth: x, y, z of its corners.
using Solid = std::array<std::array<double, 3>, 3>;

/// 0: nowhere nearer than `from` - `tmin`; 1: nearer; 2 unsure, by the plane at (x, y) and what it may be
/// wrong by: that, and as much again as coordinates wrong by `across` and depths wrong by `along` make it
/// (negative: less), for clear answers.
unsigned height(const Solid& solid, Place at, double from, double tmin, double margin, double margin_z,
                double across = 0, double along = 0);
/// Whether who rounds must answer the same, planes by that much.
bool is_clear_height(const Solid& solid, Place at, double from, double tmin, double margin, double margin_z,
                     double across, double along);

/// Whether a plane through the corners is known as seen from a point: 1 yes, 0 no, 2 too near to say for who
/// rounds.
unsigned has_plane(const Solid& solid, Place at, double margin);

/// Roundings of any input that a plane may be off by. A depth's conditioning holds, besides, one part in so
/// many of what the kernel itself says that slopes carry to it: between the corners of a needle each slope is
/// known badly, and only both together well. There a depth is held to no more than the kernel's own bound;
/// that this is one is tested without any tolerance (tests/hybrid_kernels/column_test.cpp).
constexpr double plane_roundings = 8;

Truth column_plane(const Arguments& a_b_c_at_half_side_margin);
Truth column_depth_bounds(const Arguments& a_b_c_centre_half_side_margin);

} // namespace gnomon::reference::hybrid
