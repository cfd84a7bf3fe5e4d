// Inputs of the integrals' kernels: ordinary cells and lobes, and the loci on which formulas lose digits or
// divide by zero (docs/integrals.md lists them with what each does to which formula).
#pragma once

#include "casegen/kernel_case.h"

#include <memory>

namespace gnomon::stiffness {

/// What follows a cell under a boundary, or an interval of φ, in a kernel's parameters.
enum class Trailing { nothing, angle, two_angles, vector, two_vectors };

/// phi0, phi1, theta0, k, b, then `trailing`. All of them draw the same cells.
std::shared_ptr<const Generator> boundary_cells(Trailing trailing);
/// Whether θ0 and both ends of kφ + b lie in [0, π], and φ0 … φ1 spans at most a turn; either may be
/// reversed.
bool is_boundary_cell(const Arguments& arguments);

/// phi0, phi1, then `phases` angles, then s and t if `wave`.
std::shared_ptr<const Generator> waves(int phases, bool wave);
/// Whether φ0 … φ1 spans at most a turn, and the second wave, whose frequency is the `s`th number (0: there
/// is none), no more than 200 radians of it, and none beyond 8000.
std::function<bool(const Arguments&)> is_wave(std::size_t s);

/// versines (1 - a, 1 - b), lambda, mu; and the same with the ends (a, b).
std::shared_ptr<const Generator> lobes();
std::shared_ptr<const Generator> lobes_of_ends();
bool is_lobe(const Arguments& arguments);
bool is_lobe_of_ends(const Arguments& arguments);

/// phi, half, theta (2), p (3).
std::shared_ptr<const Generator> cells_and_axes();
bool is_cell_and_axis(const Arguments& arguments);

/// phi, half, theta0, rise (2), n (3), p (3), lambda, mu, versines (2). The versines hold all that x = p̂·ω
/// does in the cell.
std::shared_ptr<const Generator> lit_cells();
bool is_lit_cell(const Arguments& arguments);

} // namespace gnomon::stiffness
