// Exact geometry on a lattice: coordinates are whole multiples of one power of two, so that every area and
// every plane's depth is a whole number of 128 bits. Floats of one magnitude are such multiples.
#pragma once

#include "casegen/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace gnomon::testing {

__extension__ typedef __int128 Wide;

/// In units; coordinates below 2^31, so that areas are below 2^65 and depths times areas below 2^98.
struct LatticePoint {
    std::int64_t x, y;
    std::int64_t z = 0;
};

inline Wide area2(LatticePoint p, LatticePoint q, LatticePoint r) {
    return Wide(q.x - p.x) * (r.y - p.y) - Wide(q.y - p.y) * (r.x - p.x);
}
inline int sign(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// The float nearest to a whole number below 2^40, as a whole number: one that a float holds.
inline std::int64_t rounded(double x) {
    return static_cast<std::int64_t>(static_cast<float>(std::nearbyint(x)));
}

/// Three points wound one way or the other.
struct LatticeTriangle {
    std::array<LatticePoint, 3> p;

    Wide area2() const { return testing::area2(p[0], p[1], p[2]); }
    /// Within or on the border; of a triangle without area: on its longest side.
    bool holds(LatticePoint at) const {
        const int turn = sign(area2());
        bool within = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const int side = sign(testing::area2(p[i], p[(i + 1) % 3], at));
            within = within && (turn == 0 ? side == 0 : side * turn >= 0);
        }
        for (auto axis : {&LatticePoint::x, &LatticePoint::y}) {
            within = within && at.*axis >= std::min({p[0].*axis, p[1].*axis, p[2].*axis}) &&
                     at.*axis <= std::max({p[0].*axis, p[1].*axis, p[2].*axis});
        }
        return within;
    }
    /// Within and not on the border.
    bool holds_inside(LatticePoint at) const {
        const int turn = sign(area2());
        for (std::size_t i = 0; i < 3; ++i)
            if (turn == 0 || sign(testing::area2(p[i], p[(i + 1) % 3], at)) != turn) return false;
        return true;
    }
    /// Its plane's depth at a point against z there: -1 nearer to the light, 0, 1 farther. It has an area.
    int depth_against(LatticePoint at, std::int64_t z) const {
        const Wide area = area2();
        Wide sum = -Wide(z) * area;
        for (std::size_t i = 0; i < 3; ++i)
            sum += testing::area2(p[(i + 1) % 3], p[(i + 2) % 3], at) * p[i].z;
        return sign(sum) * sign(area);
    }
};

/// Whether segments pq and rs have a point in common.
inline bool cross(LatticePoint p, LatticePoint q, LatticePoint r, LatticePoint s) {
    for (auto axis : {&LatticePoint::x, &LatticePoint::y})
        if (std::max(p.*axis, q.*axis) < std::min(r.*axis, s.*axis) ||
            std::max(r.*axis, s.*axis) < std::min(p.*axis, q.*axis))
            return false;
    return sign(area2(p, q, r)) * sign(area2(p, q, s)) <= 0 &&
           sign(area2(r, s, p)) * sign(area2(r, s, q)) <= 0;
}

inline std::array<LatticePoint, 4> square_round(LatticePoint centre, std::int64_t half) {
    return {LatticePoint{centre.x - half, centre.y - half},
            {centre.x + half, centre.y - half},
            {centre.x + half, centre.y + half},
            {centre.x - half, centre.y + half}};
}

/// Whether a segment meets a closed square, by its ends and its crossings.
inline bool segment_meets(LatticePoint p, LatticePoint q, LatticePoint centre, std::int64_t half) {
    const auto inside = [&](LatticePoint a) {
        return std::abs(a.x - centre.x) <= half && std::abs(a.y - centre.y) <= half;
    };
    if (inside(p) || inside(q)) return true;
    const auto corners = square_round(centre, half);
    for (std::size_t i = 0; i < 4; ++i)
        if (cross(p, q, corners[i], corners[(i + 1) % 4])) return true;
    return false;
}
/// Whether a triangle meets a closed square: a side does, or the square is within.
inline bool triangle_meets(const LatticeTriangle& t, LatticePoint centre, std::int64_t half) {
    for (std::size_t i = 0; i < 3; ++i)
        if (segment_meets(t.p[i], t.p[(i + 1) % 3], centre, half)) return true;
    return t.holds(centre);
}

} // namespace gnomon::testing
