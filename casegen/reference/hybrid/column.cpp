#include "casegen/reference/hybrid/column.h"

#include "casegen/reference/hybrid/number.h"
#include "casegen/reference/hybrid/rounded.h"

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

/// What touches the square meets it: a little more than doubles round.
bool polygon_meets_square(Outline outline, Place centre, double half_side) {
    double farthest = 0;
    for (Place& p : outline) {
        p = {p.x - centre.x, p.y - centre.y};
        farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
    }
    half_side += 0x1p-40 * farthest;
    for (double Place::*axis : {&Place::x, &Place::y})
        for (const double sign : {-1.0, 1.0}) outline = clipped(outline, axis, sign, half_side);
    return !outline.empty();
}

Place moved(Place p, unsigned corner, double by) {
    return {p.x + ((corner & 1) != 0 ? by : -by), p.y + ((corner & 2) != 0 ? by : -by)};
}

/// The sum of a vector's absolute components.
double extent(Place from, Place to) { return std::abs(to.x - from.x) + std::abs(to.y - from.y); }

/// Sums that are no more than this may be all that is left of products that vanish.
constexpr double vanishing = static_cast<double>(1e-37F);

/// On which side of ab all of c's square is, wherever a and b are in theirs: 1, -1, or 0 if it is not, or not
/// by more than the eight roundings that are left unsure.
int side_for_all(Place a, Place b, Place c, double margin) {
    int side = 0;
    const double unsure = 0x1p-21 * extent(a, b) * extent(a, c) + vanishing;
    for (unsigned i = 0; i < 64; ++i) {
        const double area =
            area2(moved(a, i >> 4, margin), moved(b, i >> 2 & 3, margin), moved(c, i & 3, margin));
        const int here = area > unsure ? 1 : area < -unsure ? -1 : 0;
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

/// That sum as floats make it: what is 2^30 times as large it leaves as it is.
Rounded and_vanishing(const Rounded& unsure) { return unsure.low() > 0x1p-90 ? unsure : unsure + vanishing; }

/// The farthest that a corner is from a point, in x or in y.
double farthest_corner(const Triangle<double>& triangle, Place p) {
    double farthest = 0;
    for (const Place& corner : triangle)
        farthest = std::max({farthest, std::abs(corner.x - p.x), std::abs(corner.y - p.y)});
    return farthest;
}

/// What the roundings of products, whose difference is a thin triangle's area, make of a depth by its slope:
/// 2^-23 of the rise, times the longest side over the area, times the way to the farthest corner and `beyond`
/// it, in texels.
template <typename T>
T carried_by_slopes(const std::array<T, 3>& x, const std::array<T, 3>& y, const std::array<T, 3>& z,
                    const T& beyond) {
    const auto greater = [](const T& p, const T& q) { return p < q ? q : p; };
    T longest(0), farthest(0), rise(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        longest = greater(longest, magnitude(x[i] - x[k]) + magnitude(y[i] - y[k]));
        farthest = greater(farthest, magnitude(x[i]) + magnitude(y[i]));
        rise = greater(rise, magnitude(z[i] - z[k]));
    }
    const T area = magnitude((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]));
    return T(0x1p-23) * rise * (longest / area) * (farthest + beyond);
}

/// Slope along x and y, depth, and how wrong that may be, round the point at 9 and 10 within half_side at 11,
/// of corners that may be off by the margin at 12; and by no less than half an ulp of how far they are.
template <typename T>
std::array<T, 4> plane(const std::array<T, 16>& n) {
    const std::array<T, 3> x{n[0] - n[9], n[3] - n[9], n[6] - n[9]}, z{n[2], n[5], n[8]},
        y{n[1] - n[10], n[4] - n[10], n[7] - n[10]};
    const Weights<T> weights(x, y);
    std::array<T, 4> found{T(0), T(0), T(0), T(0)};
    T largest(0), margin = n[12];
    for (std::size_t i = 0; i < 3; ++i) {
        for (const T& away : {x[i], y[i]})
            if (margin < T(0x1p-24) * magnitude(away)) margin = T(0x1p-24) * magnitude(away);
        // Less the first corner's depth: it drops out of both slopes, and the doubles keep their digits.
        found[0] = found[0] + weights.by_x[i] * (z[i] - z[0]);
        found[1] = found[1] + weights.by_y[i] * (z[i] - z[0]);
        found[2] = found[2] + weights.constant[i] * (z[i] - z[0]);
        largest = largest + magnitude(weights.constant[i]) +
                  n[11] * (magnitude(weights.by_x[i]) + magnitude(weights.by_y[i]));
    }
    found[2] = found[2] + z[0];
    const T steep = magnitude(found[0]) + magnitude(found[1]);
    found[3] = T(2) * margin * steep * largest;
    found[3] = found[3] + carried_by_slopes(x, y, z, n[11]);
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

/// What a depth's conditioning holds of that: see plane_roundings.
double carried_share(const Arguments& arguments, double beyond) {
    const auto& n = arguments.numbers;
    return carried_by_slopes<double>({n[0] - n[9], n[3] - n[9], n[6] - n[9]},
                                     {n[1] - n[10], n[4] - n[10], n[7] - n[10]}, {n[2], n[5], n[8]}, beyond) /
           plane_roundings;
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
/// Twice the margin, and no less than eight roundings of how far corners are.
double unsure_within(const Triangle<double>& triangle, Place p, double margin) {
    return std::max(2 * margin, 0x1p-21 * farthest_corner(triangle, p));
}
unsigned coverage_wound(const Triangle<double>& triangle, Place p, double off, double turn) {
    if (!meets_square(triangle, p, off)) return 8;
    unsigned unsure = 0;
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned corner = 0; corner < 4; ++corner)
            if (!(turn * area2(triangle[i], triangle[(i + 1) % 3], moved(p, corner, off)) > vanishing))
                unsure |= 1u << i;
    return unsure;
}
double area_of(const Triangle<double>& t) { return area2(t[0], t[1], t[2]); }
} // namespace

unsigned coverage(const Triangle<double>& triangle, Place p, double margin) {
    return coverage_wound(triangle, p, unsure_within(triangle, p, margin), area_of(triangle) < 0 ? -1 : 1);
}

bool is_clear_coverage(const Triangle<double>& triangle, Place p, double margin, double rounding) {
    const double off = unsure_within(triangle, p, margin);
    const bool meets = meets_square(triangle, p, off + rounding);
    if (meets != meets_square(triangle, p, std::max(0.0, off - rounding))) return false;
    if (!meets) return true;
    // Which edges are near is asked of every float that their sums may be rounded to.
    std::array<Rounded, 3> x{0, 0, 0}, y{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
        x[i] = Rounded(triangle[i].x) - p.x, y[i] = Rounded(triangle[i].y) - p.y;
    Rounded far = 0;
    for (std::size_t i = 0; i < 3; ++i) far = max(far, max(abs(x[i]), abs(y[i])));
    const Rounded within = max(2 * margin, 0x1p-21 * far);
    std::array<Rounded, 3> at{0, 0, 0}, unsure{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const Place &here = triangle[i], &next = triangle[(i + 1) % 3];
        const Rounded along_x = Rounded(next.x) - here.x, along_y = Rounded(next.y) - here.y;
        at[i] = cross(x[i], y[i], along_x, along_y);
        unsure[i] = and_vanishing(within * (abs(along_x) + abs(along_y)));
    }
    const Rounded area = at[0] + at[1] + at[2];
    const bool is_left = surely_greater(area, 0), is_right = surely_greater(0, area);
    for (std::size_t i = 0; i < 3; ++i) {
        const bool left = surely_greater(at[i], unsure[i]), right = surely_greater(-at[i], unsure[i]);
        const bool not_left = surely_not_greater(at[i], unsure[i]),
                   not_right = surely_not_greater(-at[i], unsure[i]);
        if (is_left ? !(left || not_left) : is_right ? !(right || not_right) : !(not_left && not_right))
            return false;
    }
    return true;
}

bool is_clear_opposite(Place a, Place b, Place c, Place d, double margin) {
    const Rounded x = Rounded(b.x) - a.x, y = Rounded(b.y) - a.y;
    std::array<Rounded, 2> at{0, 0}, unsure{0, 0};
    for (std::size_t i = 0; i < 2; ++i) {
        const Place p = i == 0 ? c : d;
        const Rounded to_x = Rounded(p.x) - a.x, to_y = Rounded(p.y) - a.y;
        const Rounded along = abs(x) + abs(y), across = abs(to_x) + abs(to_y);
        at[i] = cross(x, y, to_x, to_y);
        // What moving all points can do at worst, which is not what it does to any four.
        unsure[i] = and_vanishing(2 * margin * (along + across) + 0x1p-21 * along * across);
    }
    const auto all = [&](auto surely, double side) {
        return surely(side * at[0], unsure[0]) && surely(-side * at[1], unsure[1]);
    };
    const auto greater = [](const Rounded& p, const Rounded& q) { return surely_greater(p, q); };
    if (all(greater, 1) || all(greater, -1)) return true;
    const auto none = [&](double side) {
        return surely_not_greater(side * at[0], unsure[0]) || surely_not_greater(-side * at[1], unsure[1]);
    };
    return none(1) && none(-1) && !are_opposite(a, b, c, d, margin);
}

unsigned has_plane(const Solid& solid, Place at, double margin) {
    Rounded far = 0, longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &p = solid[i], &q = solid[(i + 1) % 3];
        far = max(far, max(abs(Rounded(p[0]) - at.x), abs(Rounded(p[1]) - at.y)));
        longest = max(longest, abs(Rounded(q[0]) - p[0]) + abs(Rounded(q[1]) - p[1]));
    }
    const Rounded area = abs(cross(Rounded(solid[1][0]) - solid[0][0], Rounded(solid[1][1]) - solid[0][1],
                                   Rounded(solid[2][0]) - solid[0][0], Rounded(solid[2][1]) - solid[0][1]));
    const Rounded least = 64 * max(margin, 0x1p-24 * far) * longest;
    return surely_greater(area, least) ? 1 : surely_not_greater(area, least) ? 0 : 2;
}

namespace {
/// Depths are unsure by no less than four roundings of the largest of them.
double unsure_depth(const std::array<double, 2>& range, double from, double tmin, double margin_z) {
    return std::max(margin_z, 0x1p-22 * std::max({std::abs(range[0]), std::abs(range[1]),
                                                  std::abs(from) + std::abs(tmin)}));
}
} // namespace

unsigned height(const Solid& solid, Place at, double from, double tmin, double margin, double margin_z,
                double across, double along) {
    const std::array<double, 2> range = range_of(solid);
    const double end = from - tmin, unsure = unsure_depth(range, from, tmin, margin_z);
    const auto of = [&](double nearest, double farthest) {
        return nearest > end ? 0u : farthest < end ? 1u : 2u;
    };
    // Beside the triangle, where its plane leaves its range, nothing passes: that it says what the range
    // does.
    const unsigned by_range = of(range[0] - unsure, range[1] + unsure);
    if (by_range != 2 || has_plane(solid, at, margin) != 1) return by_range;
    std::array<double, 16> numbers{};
    for (std::size_t i = 0; i < 9; ++i) numbers[i] = solid[i / 3][i % 3];
    numbers[9] = at.x, numbers[10] = at.y, numbers[11] = numbers[12] = margin;
    const double depth = plane(numbers)[2], wrong = plane(numbers)[3];
    numbers[12] = std::abs(across);
    const double more = plane(numbers)[3],
                 all = std::max(0.0, across < 0 ? wrong - more : wrong + more) + unsure + along;
    return of(depth - all, depth + all);
}

bool is_clear_height(const Solid& solid, Place at, double from, double tmin, double margin, double margin_z,
                     double across, double along) {
    const auto [nearest, farthest] = range_of(solid);
    const Rounded end = Rounded(from) - tmin;
    const Rounded deepest = std::max(std::abs(nearest), std::abs(farthest));
    const Rounded unsure = max(margin_z, 0x1p-22 * max(deepest, Rounded(std::abs(from)) + std::abs(tmin)));
    const Rounded least = Rounded(nearest) - unsure, most = Rounded(farthest) + unsure;
    if (surely_greater(least, end) || surely_greater(end, most)) return true;
    if (!surely_not_greater(least, end) || !surely_not_greater(end, most)) return false;
    if (nearest == farthest) return true; // no plane, and one at that depth, say the same
    const unsigned known = has_plane(solid, at, margin);
    const auto with = [&](double sign) {
        return height(solid, at, from, tmin, margin, margin_z, sign * across, sign * along);
    };
    return known == 0 || (known == 1 && with(1) == with(-1));
}

Truth column_plane(const Arguments& arguments) {
    Truth truth = truth_of(arguments, magnitudes_of(arguments), [](const auto& n) { return plane(n); });
    truth.conditioning[2] += carried_share(arguments, 0);
    return truth;
}

Truth column_depth_bounds(const Arguments& arguments) {
    const Solid solid = solid_of(arguments);
    const std::array<double, 2> range = range_of(solid);
    Truth truth;
    truth.scale = std::max(std::abs(range[0]), std::abs(range[1]));
    if (has_plane(solid, {arguments.numbers[9], arguments.numbers[10]}, arguments.numbers[12]) != 1) {
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
    truth.conditioning[0] = truth.conditioning[1] = std::ranges::max(corners.conditioning) +
                                                    carried_share(arguments, arguments.numbers[11]) +
                                                    0x1p-20 * wrong;
    return truth;
}

} // namespace gnomon::reference::hybrid
