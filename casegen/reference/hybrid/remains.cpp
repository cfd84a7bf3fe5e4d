#include "casegen/reference/hybrid/remains.h"

#include "casegen/reference/hybrid/truth.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon::reference::hybrid {
namespace {

/// Distances in units of lambda: of[0] d0 + of[1] d1 + of[2] d2 >= least, in whole numbers.
struct HalfPlane {
    unsigned number;
    std::array<int, 3> of;
    int least;
};

std::vector<HalfPlane> half_planes(unsigned away, unsigned cut) {
    std::vector<HalfPlane> planes;
    for (unsigned k = 0; k < 3; ++k) {
        std::array<int, 3> edge{}, both{};
        edge[k] = both[k] = both[(k + 2) % 3] = 1;
        if ((cut >> k & 1) != 0) planes.push_back({2 * k, both, 1});
        planes.push_back({2 * k + 1, edge, (away >> k & 1) != 0 ? 0 : 1});
    }
    return planes;
}

/// Three distances are those of one point if x0 d0 + x1 d1 + x2 d2 = 1 with the shares x_k of lambda in the
/// heights on the edges: both sides are the triangle's area over itself. So whatever decides is
///     of[0] x0 + of[1] x1 + of[2] x2 + rest
/// in whole numbers, and a share that is off by some part of itself moves it by no more than `part` times
/// the sum of its terms that are no whole numbers.
struct Decision {
    double value = 0, off = 0;
    bool is_positive() const { return value > off; }
    bool is_negative() const { return value < -off; }
};
using Shares = std::array<double, 3>;

int determinant(const std::array<int, 3>& a, const std::array<int, 3>& b, const std::array<int, 3>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Decision decision(const std::array<int, 3>& of, int rest, const Shares& shares, double part) {
    Decision result{static_cast<double>(rest), 0};
    for (std::size_t k = 0; k < 3; ++k) {
        result.value += of[k] * shares[k];
        result.off += part * std::abs(of[k]) * shares[k];
    }
    return result;
}

/// Positive if `a` turns to `b` the way that edge 0 turns to edge 1: the determinant of both and the shares.
Decision turn(const HalfPlane& a, const HalfPlane& b, const Shares& shares, double part) {
    const std::array<int, 3> cross{a.of[1] * b.of[2] - a.of[2] * b.of[1],
                                   a.of[2] * b.of[0] - a.of[0] * b.of[2],
                                   a.of[0] * b.of[1] - a.of[1] * b.of[0]};
    return decision(cross, 0, shares, part);
}

/// How far within `c` the point is where `a` and `b` meet, times their turn. By Cramer's rule, c.of . d -
/// c.least is a quotient of determinants, whose numerator is the determinant of the rows (a, least), (b,
/// least), (c, least), (shares, 1), expanded here by its last row.
Decision within(const HalfPlane& a, const HalfPlane& b, const HalfPlane& c, const Shares& shares,
                double part) {
    std::array<int, 3> of{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto with_least = [k](const HalfPlane& plane) {
            std::array<int, 3> row = plane.of;
            row[k] = plane.least;
            return row;
        };
        of[k] = -determinant(with_least(a), with_least(b), with_least(c));
    }
    return decision(of, determinant(a.of, b.of, c.of), shares, part);
}

/// Where a corner stands: walking round from v0, every edge has a place for its beginning, 2 k, and one for
/// its end, 2 k + 1. A corner between an edge and the cut at its end is that end; any other is where an edge
/// begins, or would begin that is lost, the first of several.   [docs/decisions.md H8]
unsigned place(const RemainsCorner& corner) {
    if (corner.before % 2 == 0) return corner.before;
    return corner.behind == (corner.before + 1) % 6 ? corner.before : (corner.before + 1) % 6;
}

} // namespace

Remains remains(const Triangle<double>& triangle, double lambda, unsigned away, unsigned cut) {
    Remains result;
    const double sine = least_sine(triangle);
    if (!is_clear(sine) || !(lambda >= 0)) return result;
    result.is_clear = true;
    if (!is_broad(sine)) return result;
    // A share is lambda / (edge * edge * sine / edge). Rounding the triangle's differences of coordinates, of
    // 2^-24 each, turns either direction by 2^-24 and so moves a sine by 2^-23; a kernel's sines are good to
    // 2^-22 (kernels/conservative/lines.glslh), which is 4 roundings over the sine of the share, and a
    // length, the product, the quotient and a sum of three take 7 more: together less than 16 roundings over
    // the sine.
    const double part = 0x1p-20 / sine;
    const double area = std::abs(area2(triangle[0], triangle[1], triangle[2]));
    Shares shares;
    for (std::size_t k = 0; k < 3; ++k)
        shares[k] = length(triangle[k], triangle[(k + 1) % 3]) / area * lambda;
    // The smallest lambda there is decides as one does whose shares are nothing beside 1.
    if (lambda == 0)
        for (std::size_t k = 0; k < 3; ++k)
            shares[k] = 0x1p-60 * length(triangle[k], triangle[(k + 1) % 3]) / std::sqrt(area);
    const std::vector<HalfPlane> planes = half_planes(away, cut);
    for (const HalfPlane& a : planes)
        for (const HalfPlane& b : planes) {
            if (a.number == b.number) continue;
            const Decision turned = turn(a, b, shares, part);
            if (turned.is_negative()) continue;
            bool is_corner = turned.is_positive(), is_none = false;
            for (const HalfPlane& c : planes) {
                if (c.number == a.number || c.number == b.number) continue;
                const Decision side = within(a, b, c, shares, part);
                is_corner = is_corner && side.is_positive();
                is_none = is_none || side.is_negative();
            }
            if (is_corner) result.corners.push_back({a.number, b.number});
            if (!is_corner && !is_none) return {};
        }
    std::ranges::sort(result.corners, {}, place);
    return result;
}

} // namespace gnomon::reference::hybrid
