// What the kernels of kernels/conservative and kernels/adjacency are judged by, in multiprecision. Every
// function takes the numbers of its kernel in the order of its parameters.
//
// A triangle whose least sine is below `parallel` counts as a line; since kernels round, their answers are
// compared only where `is_clear` says that no rounding decides.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/reference/hybrid/lines.h"

namespace gnomon::reference::hybrid {

constexpr double parallel = 0x1p-20;
inline bool is_clear(double sine) { return sine > 2 * parallel || sine < parallel / 2; }
inline bool is_broad(double sine) { return sine > 2 * parallel; }

/// Corners at numbers `first`, `first` + `stride` and `first` + 2 `stride`, x before y.
Triangle<double> triangle_of(const Arguments& arguments, std::size_t first = 0, std::size_t stride = 2);

Truth line_intersection(const Arguments& a_b_c_d_otherwise);
double sine_between(const Arguments& a_b_c_d);

Truth inward(const Arguments& a_b_inside);
/// The triangle's corner when its edges move in by lambda.
Truth eroded(const Arguments& a_b_c_lambda_corner);
Truth dilated(const Arguments& a_b_c_lambda_corner);
Truth clip_box(const Arguments& a_b_c_lambda);
Truth tight_offset(const Arguments& normal_texel);
Truth depth_at(const Arguments& a_b_c_p);
Truth depth_bounds(const Arguments& a_b_c_p_half_texel);

/// A vertex of the fan that covers what is left between lit and shadowed neighbours (remains.h), from its
/// first corner on; behind the last triangle the last corner, v0 if nothing is left. Only where `remains` is
/// clear.
Truth shrunken(const Arguments& v0_v2_v4_lambda, unsigned away, unsigned cut, unsigned emitted);
/// The corners between two edges that stay.
unsigned between(unsigned away);
unsigned bit_count(unsigned bits);

} // namespace gnomon::reference::hybrid
