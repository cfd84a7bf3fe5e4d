// Plane geometry by lines, for any type of number: a line is what a x + b y = c holds on, with (a, b) of
// length 1; edges are lines, moving an edge changes c, and corners are solutions of two equations. The
// kernels work with directions, bisectors and barycentric weights instead.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gnomon::reference::hybrid {

template <typename T>
struct Point {
    T x, y;
};

template <typename T>
struct Line {
    T a, b, c;
};

template <typename T>
using Triangle = std::array<Point<T>, 3>;

/// Twice the area of p q r, positive if they turn from x towards y.
template <typename T>
T area2(const Point<T>& p, const Point<T>& q, const Point<T>& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}
template <typename T>
T length(const Point<T>& p, const Point<T>& q) {
    using std::sqrt;
    const T x = q.x - p.x, y = q.y - p.y;
    return sqrt(x * x + y * y);
}

/// The line through p and q, moved by `by` to the side of `inside`.
template <typename T>
Line<T> moved_line(const Point<T>& p, const Point<T>& q, const Point<T>& inside, const T& by) {
    const T of = length(p, q), turn = area2(p, q, inside) < T(0) ? T(-1) : T(1);
    const T a = turn * (p.y - q.y) / of, b = turn * (q.x - p.x) / of;
    return {a, b, a * p.x + b * p.y + by};
}

/// Where two lines meet, by Cramer's rule.
template <typename T>
Point<T> meet(const Line<T>& first, const Line<T>& second) {
    const T determinant = first.a * second.b - second.a * first.b;
    return {(second.b * first.c - first.b * second.c) / determinant,
            (first.a * second.c - second.a * first.c) / determinant};
}

/// Edge i of a triangle, from corner i to the next, moved in by `by`.
template <typename T>
Line<T> edge(const Triangle<T>& triangle, std::size_t i, const T& by) {
    return moved_line(triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3], by);
}

/// The least sine of a triangle's angles; 0 if two corners are one.
template <typename T>
T least_sine(const Triangle<T>& triangle) {
    std::array<T, 3> lengths;
    T longest_two(0);
    for (std::size_t i = 0; i < 3; ++i) lengths[i] = length(triangle[i], triangle[(i + 1) % 3]);
    for (std::size_t i = 0; i < 3; ++i) {
        const T product = lengths[i] * lengths[(i + 1) % 3];
        if (product > longest_two) longest_two = product;
    }
    for (const T& each : lengths)
        if (!(each > T(0))) return T(0);
    const T area = area2(triangle[0], triangle[1], triangle[2]);
    return (area < T(0) ? T(0) - area : area) / longest_two;
}

} // namespace gnomon::reference::hybrid
