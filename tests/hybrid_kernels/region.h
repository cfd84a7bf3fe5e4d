// Convex polygons in exact numbers: regions as sets of half-planes, cut out of a triangle one after the
// other. Half-planes whose distances are lengths come in 57 digits, floats and their areas as rationals.
#pragma once

#include "casegen/reference/hybrid/number.h"
#include "tests/hybrid_kernels/rows.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <vector>

namespace gnomon::testing {

using Real = hybrid_truth::Real;
using Rational = boost::multiprecision::cpp_rational;
template <typename T>
using Polygon = std::vector<hybrid_truth::Point<T>>;

/// a x + b y >= c.
using HalfPlane = hybrid_truth::Line<Real>;

template <typename T>
hybrid_truth::Triangle<T> as(const Corners& corners) {
    hybrid_truth::Triangle<T> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = {T(corners[i].x), T(corners[i].y)};
    return result;
}

/// Twice the area, positive whichever way it is wound.
template <typename T>
T area2_of(const Polygon<T>& polygon) {
    T sum(0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += hybrid_truth::area2(polygon[0], polygon[i - 1], polygon[i]);
    return sum < 0 ? T(-sum) : sum;
}

inline Real side(const HalfPlane& plane, const hybrid_truth::Point<Real>& p) {
    return plane.a * p.x + plane.b * p.y - plane.c;
}

inline Polygon<Real> clipped(const Polygon<Real>& polygon, const HalfPlane& plane) {
    Polygon<Real> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        const Real from = side(plane, here), to = side(plane, next);
        if (from >= 0) result.push_back(here);
        if ((from >= 0) != (to >= 0)) {
            const Real t = from / (from - to);
            result.push_back({here.x + t * (next.x - here.x), here.y + t * (next.y - here.y)});
        }
    }
    return result;
}

/// What is left of a triangle between its neighbours, as kernels/adjacency/polygon.glslh describes it: at
/// least lambda from lit edges, at least lambda from both edges together at corners that are cut.
inline std::vector<HalfPlane> half_planes(const Trial& trial, unsigned away, unsigned cut) {
    const auto corners = as<Real>(trial.corners);
    const Real lambda = trial.lambda;
    std::vector<HalfPlane> planes, edges;
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(hybrid_truth::edge(corners, i, Real(0)));
    for (std::size_t i = 0; i < 3; ++i) {
        planes.push_back(edges[i]);
        if ((away >> i & 1) == 0) planes.back().c += lambda;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const HalfPlane &next = edges[i], &previous = edges[(i + 2) % 3];
        if ((cut >> i & 1) != 0)
            planes.push_back({next.a + previous.a, next.b + previous.b, next.c + previous.c + lambda});
    }
    return planes;
}
inline Polygon<Real> region(const Trial& trial, const std::vector<HalfPlane>& planes) {
    const auto corners = as<Real>(trial.corners);
    Polygon<Real> polygon(corners.begin(), corners.end());
    for (const HalfPlane& plane : planes) polygon = clipped(polygon, plane);
    return polygon;
}

/// Twice the area of triangles whose corners are floats, exactly, each counted positive.
inline Rational area2_of(const std::vector<Corners>& triangles) {
    Rational sum(0);
    for (const Corners& each : triangles) {
        const auto exact = as<Rational>(each);
        sum += area2_of(Polygon<Rational>(exact.begin(), exact.end()));
    }
    return sum;
}

} // namespace gnomon::testing
