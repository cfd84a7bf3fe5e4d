#include "casegen/reference/hybrid/truth.h"

#include "casegen/reference/hybrid/number.h"
#include "casegen/reference/hybrid/remains.h"

#include <vector>

namespace gnomon::reference::hybrid {
namespace {

template <typename T>
using Sixteen = std::array<T, 16>;

template <typename T>
Triangle<T> triangle_in(const Sixteen<T>& n, std::size_t stride = 2) {
    return {Point<T>{n[0], n[1]}, {n[stride], n[stride + 1]}, {n[2 * stride], n[2 * stride + 1]}};
}

/// The largest magnitude of some numbers, for each of them.
double largest_of(const Arguments& arguments, std::initializer_list<std::size_t> which) {
    double largest = 0;
    for (const std::size_t i : which) largest = std::max(largest, std::abs(arguments.numbers[i]));
    return largest;
}

/// Of six coordinates and a distance.
std::array<double, 7> of_triangle_and_distance(const Arguments& arguments) {
    std::array<double, 7> magnitudes;
    magnitudes.fill(largest_of(arguments, {0, 1, 2, 3, 4, 5}));
    magnitudes[6] = std::abs(arguments.numbers[6]);
    return magnitudes;
}

Truth moved(const Arguments& arguments, double sign) {
    const auto corner = static_cast<std::size_t>(arguments.numbers[7]) % 3;
    return truth_of(arguments, of_triangle_and_distance(arguments), [&](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        const Triangle<T> triangle = triangle_in(n);
        const T by = T(sign) * n[6];
        const Point<T> point = meet(edge(triangle, (corner + 2) % 3, by), edge(triangle, corner, by));
        return std::array{point.x, point.y};
    });
}

/// Of three corners with depth, a point, and half a texel's extents if they are there.
template <std::size_t count>
std::array<double, count> of_depths(const Arguments& arguments) {
    std::array<double, count> magnitudes;
    magnitudes.fill(largest_of(arguments, {0, 1, 3, 4, 6, 7, 9, 10}));
    for (std::size_t i = 2; i <= 8; i += 3) magnitudes[i] = largest_of(arguments, {2, 5, 8});
    for (std::size_t i = 11; i < count; ++i) magnitudes[i] = largest_of(arguments, {11, 12});
    return magnitudes;
}

/// The plane z = a x + b y + c through three points, by its normal; `depth` at a point, `rise` over a box.
template <typename T>
struct Plane {
    std::array<T, 3> normal;
    std::array<T, 3> point;

    explicit Plane(const Sixteen<T>& n) : point{n[0], n[1], n[2]} {
        std::array<T, 3> p, q;
        for (std::size_t i = 0; i < 3; ++i) p[i] = n[3 + i] - n[i], q[i] = n[6 + i] - n[i];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            normal[i] = p[j] * q[k] - p[k] * q[j];
        }
    }
    T depth(const T& x, const T& y) const {
        return point[2] - (normal[0] * (x - point[0]) + normal[1] * (y - point[1])) / normal[2];
    }
};
template <typename T>
T least(const T& a, const T& b) {
    return b < a ? b : a;
}
template <typename T>
T most(const T& a, const T& b) {
    return a < b ? b : a;
}
template <typename T>
std::array<T, 2> depth_range(const Sixteen<T>& n) {
    return {least(n[2], least(n[5], n[8])), most(n[2], most(n[5], n[8]))};
}
bool is_edge_on(const Arguments& arguments) { return least_sine(triangle_of(arguments, 0, 3)) < parallel; }

} // namespace

Triangle<double> triangle_of(const Arguments& arguments, std::size_t first, std::size_t stride) {
    Triangle<double> triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle[i] = {arguments.numbers[first + i * stride], arguments.numbers[first + i * stride + 1]};
    return triangle;
}

double sine_between(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const Point<double> along{n[2] - n[0], n[3] - n[1]}, across{n[6] - n[4], n[7] - n[5]}, origin{0, 0};
    const double lengths = length(origin, along) * length(origin, across);
    return lengths > 0 ? std::abs(area2(origin, along, across)) / lengths : 0;
}

Truth line_intersection(const Arguments& arguments) {
    std::array<double, 10> magnitudes;
    magnitudes.fill(largest_of(arguments, {0, 1, 2, 3, 4, 5, 6, 7}));
    magnitudes[8] = std::abs(arguments.numbers[8]), magnitudes[9] = std::abs(arguments.numbers[9]);
    const bool is_parallel = sine_between(arguments) < parallel;
    return truth_of(arguments, magnitudes, [&](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        if (is_parallel) return std::array{n[8], n[9]};
        const Point<T> a{n[0], n[1]}, b{n[2], n[3]}, c{n[4], n[5]}, d{n[6], n[7]};
        // Any point beside a line will do for its inside: it is not moved.
        const Point<T> point = meet(moved_line(a, b, c, T(0)), moved_line(c, d, a, T(0)));
        return std::array{point.x, point.y};
    });
}

Truth inward(const Arguments& arguments) {
    std::array<double, 6> magnitudes;
    magnitudes.fill(largest_of(arguments, {0, 1, 2, 3, 4, 5}));
    return truth_of(arguments, magnitudes, [](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        const Triangle<T> triangle = triangle_in(n);
        const T of = length(triangle[0], triangle[1]);
        if (!(of > T(0))) return std::array{T(0), T(0)};
        const Line<T> line = edge(triangle, 0, T(0));
        return std::array{line.a, line.b};
    });
}

Truth eroded(const Arguments& arguments) { return moved(arguments, 1); }
Truth dilated(const Arguments& arguments) { return moved(arguments, -1); }

Truth clip_box(const Arguments& arguments) {
    return truth_of(arguments, of_triangle_and_distance(arguments), [](const auto& n) {
        return std::array{least(n[0], least(n[2], n[4])) - n[6], least(n[1], least(n[3], n[5])) - n[6],
                          most(n[0], most(n[2], n[4])) + n[6], most(n[1], most(n[3], n[5])) + n[6]};
    });
}

Truth tight_offset(const Arguments& arguments) {
    std::array<double, 4> magnitudes;
    for (std::size_t i = 0; i < 4; ++i) magnitudes[i] = std::abs(arguments.numbers[i]);
    return truth_of(arguments, magnitudes, [](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        using std::abs;
        // The farthest corner of the texel along the normal.
        T farthest(0);
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
                farthest = most<T>(farthest, T(x) * n[0] * n[2] + T(y) * n[1] * n[3]);
        return std::array{farthest};
    });
}

Truth depth_at(const Arguments& arguments) {
    const bool edge_on = is_edge_on(arguments);
    return truth_of(arguments, of_depths<11>(arguments), [&](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        return std::array{edge_on ? depth_range<T>(n)[0] : Plane<T>(n).depth(n[9], n[10])};
    });
}

Truth depth_bounds(const Arguments& arguments) {
    const std::array<double, 2> range = depth_range<double>(arguments.numbers);
    const bool edge_on = is_edge_on(arguments);
    // The plane's depth at the texel's four corners.
    const Truth corners = truth_of(arguments, of_depths<13>(arguments), [&](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        if (edge_on) return std::array{T(range[0]), T(range[1]), T(range[0]), T(range[1])};
        const Plane<T> plane(n);
        return std::array{plane.depth(n[9] - n[11], n[10] - n[12]), plane.depth(n[9] + n[11], n[10] - n[12]),
                          plane.depth(n[9] - n[11], n[10] + n[12]), plane.depth(n[9] + n[11], n[10] + n[12])};
    });
    // Both ends come from one slope, and a range that cuts them off does not make it any better: what can
    // move any of the four can move both.
    const auto [nearest, farthest] = std::ranges::minmax(corners.value);
    Truth truth;
    truth.value[0] = std::clamp(nearest, range[0], range[1]);
    truth.value[1] = std::clamp(farthest, range[0], range[1]);
    truth.conditioning[0] = truth.conditioning[1] = std::ranges::max(corners.conditioning);
    truth.scale = std::max(std::abs(range[0]), std::abs(range[1]));
    return truth;
}

unsigned bit_count(unsigned bits) { return (bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1); }

unsigned between(unsigned away) {
    unsigned corners = 0;
    for (unsigned i = 0; i < 3; ++i) // corner i lies between edge i and the one before it
        if ((away >> i & 1) != 0 && (away >> (i + 2) % 3 & 1) != 0) corners |= 1u << i;
    return corners;
}

Truth shrunken(const Arguments& arguments, unsigned away, unsigned cut, unsigned emitted) {
    const std::vector<RemainsCorner> corners =
        remains(triangle_of(arguments), arguments.numbers[6], away, cut).corners;
    const std::size_t fan = emitted / 3, vertex = emitted % 3;
    const std::size_t index = fan + 2 >= corners.size() ? corners.size() - 1 : vertex == 0 ? 0 : fan + vertex;
    return truth_of(arguments, of_triangle_and_distance(arguments), [&](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        const Triangle<T> triangle = triangle_in(n);
        if (corners.empty()) return std::array{triangle[0].x, triangle[0].y};
        const Point<T> corner = meet(remains_line(triangle, n[6], away, corners[index].before),
                                     remains_line(triangle, n[6], away, corners[index].behind));
        return std::array{corner.x, corner.y};
    });
}

} // namespace gnomon::reference::hybrid
