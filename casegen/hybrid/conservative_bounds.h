// What kernels of kernels/conservative owe outside their domains, and bounds within them that must hold what
// they bound: by the words of their parameters (casegen/conservative.cpp).
#pragma once

#include "casegen/kernel_case.h"

#include <optional>
#include <span>

namespace gnomon::hybrid {

/// Nothing is left of what is not finite.
std::optional<Bounds> no_if_not_finite(std::span<const double> n);

/// Of numbers beyond the map, infinities too. What GLSL's min and max make of NaN is not said.
std::optional<Bounds> clip_box_beyond(std::span<const double> n);

/// What stands for a line when it is moved out: a right triangle with legs twice the sides of the rectangle
/// around its longest edge, which reaches `margin` beyond it on all sides. Nothing where another edge is as
/// long to within rounding: either may be taken.
std::optional<Bounds> around_a_line(std::span<const double> n);

/// A line has no inner side to speak of: left of its direction is what an axis-parallel edge is asked for
/// when `inside` lies on it, where no product is rounded, or in its first point.
std::optional<Bounds> left_of_the_edge(std::span<const double> n);

/// What a line shrinks to, and what has corners that are no numbers: its first corner.
std::optional<Bounds> first_corner(std::span<const double> n);

/// 2^-20 of all terms is twice what rounding does to their sum, wherever the texel lies: half of it.
Bounds near_the_plane(std::span<const double> n, const Truth& truth);

/// The plane's depths and that much more on either side: no less than half of it, for half of it rounding may
/// use up; no more than half as much again. Then cut off at the corners' depths. Edge-on exactly these.
Bounds around_the_plane(std::span<const double> n, const Truth& truth);

/// A texel whose extents are negative is as large as one with their magnitudes; over one that is nowhere, or
/// without end, depths are anything between the corners'.
std::optional<Bounds> anywhere_between(std::span<const double> n);

} // namespace gnomon::hybrid
