#include "casegen/reference/hybrid/column.h"

#include "casegen/reference/hybrid/number.h"

#include <algorithm>
#include <initializer_list>

namespace gnomon::reference::hybrid {
namespace {

/// A polygon's corners, on the stack. Clipping a triangle by a square's four lines leaves no more than seven
/// of them; no more than thirteen if every cut were to cross as many sides as there are.
class Outline {
public:
    Outline() = default;
    Outline(std::initializer_list<Place> places) {
        for (const Place p : places) push_back(p);
    }
    void push_back(Place p) { places_[size_++] = p; }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const Place& operator[](std::size_t i) const { return places_[i]; }
    Place* begin() { return places_.data(); }
    Place* end() { return places_.data() + size_; }

private:
    std::array<Place, 16> places_;
    std::size_t size_ = 0;
};

/// What of a polygon lies where sign * (x or y) <= limit.
Outline clipped(const Outline& outline, double Place::*axis, double sign, double limit) {
    Outline kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Place &here = outline[i], &next = outline[(i + 1) % outline.size()];
        const double from = limit - sign * here.*axis, to = limit - sign * next.*axis;
        if (from >= 0) kept.push_back(here);
        if ((from >= 0) == (to >= 0)) continue;
        const double t = from / (from - to);
        Place cut{here.x + t * (next.x - here.x), here.y + t * (next.y - here.y)};
        cut.*axis = sign * limit; // or rounding might put it outside
        kept.push_back(cut);
    }
    return kept;
}

bool polygon_meets_square(Outline outline, Place centre, double half_side) {
    for (Place& p : outline) p = {p.x - centre.x, p.y - centre.y};
    for (double Place::*axis : {&Place::x, &Place::y})
        for (const double sign : {-1.0, 1.0}) outline = clipped(outline, axis, sign, half_side);
    return !outline.empty();
}

Place moved(Place p, unsigned corner, double by) {
    return {p.x + ((corner & 1) != 0 ? by : -by), p.y + ((corner & 2) != 0 ? by : -by)};
}

/// On which side of ab all of c's square is, wherever a and b are in theirs: 1, -1, or 0 if it is not.
int side_for_all(Place a, Place b, Place c, double margin) {
    int side = 0;
    for (unsigned i = 0; i < 64; ++i) {
        const double area =
            area2(moved(a, i >> 4, margin), moved(b, i >> 2 & 3, margin), moved(c, i & 3, margin));
        const int here = area > 0 ? 1 : area < 0 ? -1 : 0;
        if (here == 0 || (i > 0 && here != side)) return 0; // most are, and soon
        side = here;
    }
    return side;
}

/// The barycentric weights of a point round the origin, as w_i = constant + by_x x + by_y y: the inverse of
/// the matrix of the corners (1, x_i, y_i).
template <typename T>
struct Weights {
    std::array<T, 3> constant, by_x, by_y;
    T area;

    Weights(const std::array<T, 3>& x, const std::array<T, 3>& y) : area(0) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            constant[i] = x[j] * y[k] - x[k] * y[j];
            by_x[i] = y[j] - y[k];
            by_y[i] = x[k] - x[j];
            area = area + constant[i];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            constant[i] = constant[i] / area;
            by_x[i] = by_x[i] / area;
            by_y[i] = by_y[i] / area;
        }
    }
};

template <typename T>
T magnitude(const T& x) {
    return x < T(0) ? T(0) - x : x;
}

/// Slope along x and y, depth, and how wrong that may be, round the point at 9 and 10 within half_side at 11,
/// of corners that may be off by the margin at 12.
template <typename T>
std::array<T, 4> plane(const std::array<T, 16>& n) {
    const std::array<T, 3> x{n[0] - n[9], n[3] - n[9], n[6] - n[9]}, z{n[2], n[5], n[8]},
        y{n[1] - n[10], n[4] - n[10], n[7] - n[10]};
    const Weights<T> weights(x, y);
    std::array<T, 4> found{T(0), T(0), T(0), T(0)};
    T largest(0);
    for (std::size_t i = 0; i < 3; ++i) {
        // Less the first corner's depth: it drops out of both slopes, and the doubles keep their digits.
        found[0] = found[0] + weights.by_x[i] * (z[i] - z[0]);
        found[1] = found[1] + weights.by_y[i] * (z[i] - z[0]);
        found[2] = found[2] + weights.constant[i] * (z[i] - z[0]);
        largest = largest + magnitude(weights.constant[i]) +
                  n[11] * (magnitude(weights.by_x[i]) + magnitude(weights.by_y[i]));
    }
    found[2] = found[2] + z[0];
    const T steep = magnitude(found[0]) + magnitude(found[1]);
    found[3] = T(2) * n[12] * steep * (largest < T(1) ? T(1) : largest);
    // The arithmetic's own error: 2^-23 of the rise, times the longest side and the farthest corner over the
    // area.
    const auto greater = [](const T& p, const T& q) { return p < q ? q : p; };
    T longest(0), farthest(0), rise(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        longest = greater(longest, magnitude(x[i] - x[k]) + magnitude(y[i] - y[k]));
        farthest = greater(farthest, magnitude(x[i]) + magnitude(y[i]));
        rise = greater(rise, magnitude(z[i] - z[k]));
    }
    const T area = magnitude((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]));
    found[3] = found[3] + T(0x1p-23) * rise * (longest / area) * (farthest + n[11]);
    return found;
}

Solid solid_of(const Arguments& arguments) {
    Solid solid;
    for (std::size_t i = 0; i < 9; ++i) solid[i / 3][i % 3] = arguments.numbers[i];
    return solid;
}

std::array<double, 13> magnitudes_of(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    double across = 0, along = 0;
    for (const std::size_t i : {0u, 1u, 3u, 4u, 6u, 7u, 9u, 10u}) across = std::max(across, std::abs(n[i]));
    for (const std::size_t i : {2u, 5u, 8u}) along = std::max(along, std::abs(n[i]));
    std::array<double, 13> magnitudes;
    magnitudes.fill(across);
    magnitudes[2] = magnitudes[5] = magnitudes[8] = along;
    magnitudes[11] = std::abs(n[11]);
    magnitudes[12] = std::abs(n[12]);
    return magnitudes;
}

std::array<double, 2> range_of(const Solid& solid) {
    return {std::min({solid[0][2], solid[1][2], solid[2][2]}),
            std::max({solid[0][2], solid[1][2], solid[2][2]})};
}

} // namespace

bool meets_square(const Triangle<double>& triangle, Place centre, double half_side) {
    // What is clipped is an outline: a square wholly within would still be met, since clipping keeps its
    // corners.
    return polygon_meets_square({triangle[0], triangle[1], triangle[2]}, centre, half_side);
}
bool segment_meets_square(Place a, Place b, Place centre, double half_side) {
    return polygon_meets_square({a, b}, centre, half_side);
}

bool are_opposite(Place a, Place b, Place c, Place d, double margin) {
    return side_for_all(a, b, c, margin) * side_for_all(a, b, d, margin) < 0;
}

namespace {
unsigned coverage_wound(const Triangle<double>& triangle, Place p, double margin, double turn) {
    if (!meets_square(triangle, p, 2 * margin)) return 8;
    unsigned unsure = 0;
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned corner = 0; corner < 4; ++corner)
            if (!(turn * area2(triangle[i], triangle[(i + 1) % 3], moved(p, corner, 2 * margin)) > 0))
                unsure |= 1u << i;
    return unsure;
}
double area_of(const Triangle<double>& t) { return area2(t[0], t[1], t[2]); }
} // namespace

unsigned coverage(const Triangle<double>& triangle, Place p, double margin) {
    return coverage_wound(triangle, p, margin, area_of(triangle) < 0 ? -1 : 1);
}

bool is_clear_coverage(const Triangle<double>& triangle, Place p, double margin, double rounding) {
    const double turn = area_of(triangle) < 0 ? -1 : 1;
    double around = 0;
    for (std::size_t i = 0; i < 3; ++i) around += length(triangle[i], triangle[(i + 1) % 3]);
    const unsigned wide = coverage_wound(triangle, p, margin + rounding, turn);
    if (wide != coverage_wound(triangle, p, std::max(0.0, margin - rounding), turn)) return false;
    return std::abs(area_of(triangle)) > rounding * around || wide == 8 ||
           wide == coverage_wound(triangle, p, margin, -turn);
}

unsigned has_plane(const Solid& solid, double margin) {
    double longest = 0, largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &p = solid[i], &q = solid[(i + 1) % 3];
        longest = std::max(longest, std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]));
        largest = std::max({largest, std::abs(p[0]), std::abs(p[1])});
    }
    const double area = std::abs(
        area2(Place{solid[0][0], solid[0][1]}, {solid[1][0], solid[1][1]}, {solid[2][0], solid[2][1]}));
    const double least = 64 * margin * longest, rounding = 0x1p-20 * (largest * longest + least) + 1e-30;
    return area > least + rounding ? 1 : area < least - rounding ? 0 : 2;
}

unsigned height(const Solid& solid, Place at, double end, double margin, double margin_z, double rounding) {
    const auto of = [&](double nearest, double farthest) {
        return nearest - margin_z > end ? 0u : farthest + margin_z < end ? 1u : 2u;
    };
    // Beside the triangle, where its plane leaves its range, nothing passes: that it says what the range
    // does.
    const std::array<double, 2> range = range_of(solid);
    const unsigned by_range = of(range[0], range[1]);
    if (by_range != 2 || has_plane(solid, margin) != 1) return by_range;
    std::array<double, 16> numbers{};
    for (std::size_t i = 0; i < 9; ++i) numbers[i] = solid[i / 3][i % 3];
    numbers[9] = at.x, numbers[10] = at.y, numbers[11] = numbers[12] = margin;
    const double depth = plane(numbers)[2], wrong = plane(numbers)[3];
    numbers[12] = std::abs(rounding);
    const double more = plane(numbers)[3], all = std::max(0.0, rounding < 0 ? wrong - more : wrong + more);
    return of(depth - all, depth + all);
}

Truth column_plane(const Arguments& arguments) {
    return truth_of(arguments, magnitudes_of(arguments), [](const auto& n) { return plane(n); });
}

Truth column_depth_bounds(const Arguments& arguments) {
    const Solid solid = solid_of(arguments);
    const std::array<double, 2> range = range_of(solid);
    Truth truth;
    truth.scale = std::max(std::abs(range[0]), std::abs(range[1]));
    if (has_plane(solid, arguments.numbers[12]) != 1) {
        truth.value = {range[0], range[1]};
        return truth;
    }
    // The plane at the square's corners, and the error around it.
    const Truth corners = truth_of(arguments, magnitudes_of(arguments), [](const auto& n) {
        using T = std::decay_t<decltype(n[0])>;
        const std::array<T, 4> p = plane(n);
        std::array<T, 4> at;
        for (unsigned i = 0; i < 4; ++i)
            at[i] = p[2] + ((i & 1) != 0 ? p[0] : T(0) - p[0]) * n[11] +
                    ((i & 2) != 0 ? p[1] : T(0) - p[1]) * n[11];
        return at;
    });
    const double wrong = column_plane(arguments).value[3];
    const auto [nearest, farthest] = std::ranges::minmax(corners.value);
    truth.value[0] = std::clamp(nearest - wrong, range[0], range[1]);
    truth.value[1] = std::clamp(farthest + wrong, range[0], range[1]);
    truth.conditioning[0] = truth.conditioning[1] = std::ranges::max(corners.conditioning) + 0x1p-20 * wrong;
    return truth;
}

} // namespace gnomon::reference::hybrid
