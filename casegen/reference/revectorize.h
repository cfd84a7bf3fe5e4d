// Revectorisation in C++ and double: what the kernels in kernels/revectorize are judged against. Written from
// the definitions in docs/revectorization.md; sections are quoted at each function.
#pragma once

#include "casegen/mask.h"

#include <glm/glm.hpp>

namespace gnomon::reference {

/// Sides on which something differs, along one axis; the bits of kernels/revectorize/sides.glslh.
enum Side : unsigned { neither = 0, minus = 1, plus = 2, both = 3 };

constexpr int longest_walk = 16;

/// Section 1. x and y hold Side bits.
glm::uvec2 discontinuity(const Mask& mask, glm::ivec2 texel);

/// Section 1.1. `heading` is a unit step along one axis.
int walk(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides, glm::ivec2 heading);

/// Towards -x, +x, -y, +y.
glm::ivec4 traversal(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides);

/// Section 1.2.
int edge_type(glm::ivec2 reach);

/// Section 1.3, by Equation 1 of RBSM 2016: 1 - max(a1, a2)/L + p_o/L, with p_o the point's distance from the
/// far border of its texel, seen from the positive end. `reach` must end on exactly one side.
double along(glm::ivec2 reach, double c);

/// The same without the limit of 16 on the run's length; and, of a run that ends on both sides, the distance
/// from the nearer end as part of the run. docs/decisions.md, A7 and A3.
double along_unclamped(glm::ivec2 reach, double c);
double along_closed(glm::ivec2 reach, double c);

/// Section 1.4.
glm::bvec2 dominance(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides);

/// Section 1.5: of a texel with a side on both along one axis, the sides along that axis of the texels next
/// along it, towards - and +.
glm::uvec2 neighbours(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides);

/// Section 1.6: Side bits, or `unbroken`.
unsigned breach(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides);
constexpr unsigned unbroken = 4;

/// What decides about a texel's case.
struct Edge {
    glm::uvec2 sides{0};
    glm::ivec4 reach{0};
    glm::ivec2 type{0};
    glm::bvec2 dominant{false};
    bool lit = true;
};
Edge edge(const Mask& mask, glm::ivec2 texel);

} // namespace gnomon::reference
