// What is left of a triangle v0 v2 v4 between lit and shadowed neighbours, told by which of its half-planes
// meet at its corners. With d0, d1, d2 the distances from the edges v0 v2, v2 v4, v4 v0, it is where
//     d_k >= lambda              if edge k moves in, because its neighbour is lit; d_k >= 0 if it stays
//     d_k + d_(k-1) >= lambda    at corner k, between edges k - 1 and k, if it is cut.
// [docs/decisions.md H6, H7]
//
// Every pair of these lines is tried: they meet at a corner of the polygon if the first turns to the second
// the way round that the triangle goes and the meeting point lies within every other half-plane. No case is
// told from another, and no order of thesis points is asked for.
#pragma once

#include "casegen/reference/hybrid/lines.h"

#include <vector>

namespace gnomon::reference::hybrid {

/// Lines are numbered walking round from v0: 2 k is where corner k is cut, 2 k + 1 is edge k.
struct RemainsCorner {
    unsigned before, behind; ///< the lines that the polygon's border follows up to here, and from here on
};

struct Remains {
    /// Whether the same lines meet at the same corners for all triangles that rounding cannot tell from this
    /// one; if not, nothing is said of them.
    bool is_clear = false;
    std::vector<RemainsCorner> corners; ///< of the polygon, in the order of H8; none if nothing is left
};

/// `away`: edges that stay, bit k; `cut`: corners, bit k, between edges that stay. Where lambda is 0 the
/// corners are those of the smallest one: at one place, but as many.
Remains remains(const Triangle<double>& triangle, double lambda, unsigned away, unsigned cut);

/// A line of the polygon, as a x + b y = c with its inner side where a x + b y is larger.
template <typename T>
Line<T> remains_line(const Triangle<T>& triangle, const T& lambda, unsigned away, unsigned number) {
    const unsigned k = number / 2;
    if (number % 2 == 1) return edge(triangle, k, (away >> k & 1) != 0 ? T(0) : lambda);
    const Line<T> behind = edge(triangle, k, T(0)), before = edge(triangle, (k + 2) % 3, T(0));
    return {before.a + behind.a, before.b + behind.b, before.c + behind.c + lambda};
}

} // namespace gnomon::reference::hybrid
