// The interval of x = p̂·ω over a cell of directions.
#pragma once

#include "casegen/reference/integral/number.h"

#include <array>

namespace gnomon::reference::integral {

/// An extremum over the cell, and its derivatives by φ, half, θ.x, θ.y, p.x, p.y, p.z.
struct Extremum {
    Real versine; ///< 1 - p̂·ω there
    std::array<Real, 7>
        by{}; ///< of p̂·ω; where several places share the extremum, of that with the largest Σ |x_i ∂_i|
};
struct CellInterval {
    Extremum least, greatest; ///< of p̂·ω
};

/// `x`: φ, half, θ.x, θ.y, p (3).
CellInterval interval_over(const std::array<Real, 7>& x);

} // namespace gnomon::reference::integral
