// The angle from the other pole, π - θ, rounded once. Near θ = π a float holds few digits of how far the pole is: cells
// there are better given from it, with their heights, the vectors' z and the result negated.
// [docs/integrals.md, section 3]
// Inputs that are not finite: 0.
#include "integral/trigonometry.glslh"
#include "integral/guard.glslh"

float integral_cell_from_south(float theta) {
    if (!is_finite(theta)) return 0.0;
    precise float rest = (PI - theta) + PI_LOW;
    return rest;
}
