#include "casegen/hybrid/conservative_bounds.h"

#include "casegen/hybrid/triangles.h"
#include "casegen/reference/hybrid/truth.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <limits>

namespace gnomon::hybrid {
namespace {

namespace truth = reference::hybrid;
using glm::dvec2, glm::dvec3;

/// What `bounded` makes of a sum of two floats, to its rounding: too large for a float, the largest; the
/// difference of two infinities, 0.
void add_bounded(Bounds& bounds, std::size_t word, double x) {
    constexpr double largest = FLT_MAX;
    const double slack = std::isfinite(x) ? 0x1p-23 * std::abs(x) : 0;
    const double answer = std::isnan(x) ? 0 : x;
    bounds.lower[word] = std::clamp(answer - slack, -largest, largest);
    bounds.upper[word] = std::clamp(answer + slack, -largest, largest);
    if (x == 0) bounds.lower[word] = -0.0, bounds.upper[word] = 0.0; // of either sign
}

bool within_the_map(std::span<const double> n) {
    return std::ranges::all_of(n, [](double x) { return std::abs(x) <= farthest; });
}

/// What the sum for a depth over a texel p +- reach is made of: from the corner nearest to p, along the
/// longest edge and across. Where two edges or corners are as good to within rounding, the least and the most
/// of them.
struct DepthTerms {
    static constexpr double underflow = 0x1p-100; ///< what factors that are hardly floats may make of a term
    double least = std::numeric_limits<double>::infinity(), most = 0;
    DepthTerms(std::span<const double> n, dvec2 reach) {
        const std::array<dvec3, 3> at{dvec3(n[0], n[1], n[2]), dvec3(n[3], n[4], n[5]),
                                      dvec3(n[6], n[7], n[8])};
        const dvec2 p(n[9], n[10]);
        std::array<double, 3> lengths{}, away{};
        for (std::size_t i = 0; i < 3; ++i) {
            lengths[i] = glm::length(dvec2(at[(i + 1) % 3]) - dvec2(at[i]));
            const dvec2 way = glm::abs(p - dvec2(at[i]));
            away[i] = std::max(way.x, way.y);
        }
        const double longest = std::ranges::max(lengths), nearest = std::ranges::min(away);
        for (std::size_t i = 0; i < 3; ++i) {
            if (lengths[i] < (1 - 0x1p-20) * longest) continue;
            const dvec3 edge = at[(i + 1) % 3] - at[i], other = at[(i + 2) % 3] - at[i];
            const dvec2 along = dvec2(edge) / lengths[i], across(-along.y, along.x);
            const double height = std::abs(glm::dot(across, dvec2(other)));
            const double rise = edge.z / lengths[i], on_edge = rise * glm::dot(along, dvec2(other));
            const double left = (other.z - on_edge) / height;
            const double made_of =
                (std::abs(other.z) + std::abs(on_edge) + std::abs(left) * glm::length(dvec2(other))) / height;
            for (const dvec3& from : at) {
                const dvec2 way = p - dvec2(from);
                if (std::max(std::abs(way.x), std::abs(way.y)) > (1 + 0x1p-20) * nearest) continue;
                const double aside =
                    std::abs(glm::dot(across, way)) + glm::dot(glm::abs(across), glm::abs(reach));
                const double terms =
                    (std::abs(rise) + std::abs(left)) * (glm::length(way) + glm::length(reach)) +
                    made_of * aside + std::abs(from.z);
                least = std::min(least, terms);
                most = std::max(most, terms);
            }
        }
    }
};

/// A depth of 0 may have either sign.
Bounds of_either_sign(Bounds bounds) {
    for (double& x : bounds.lower) x = x == 0 ? -0.0 : x;
    for (double& x : bounds.upper) x = x == 0 ? 0.0 : x;
    return bounds;
}

} // namespace

std::optional<Bounds> no_if_not_finite(std::span<const double> n) {
    if (std::ranges::all_of(n, [](double x) { return std::isfinite(x); })) return {};
    return exactly({0});
}

std::optional<Bounds> clip_box_beyond(std::span<const double> n) {
    if (std::ranges::any_of(n, [](double x) { return std::isnan(x); })) return {};
    Bounds bounds;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto [least, most] = std::minmax({n[axis], n[axis + 2], n[axis + 4]});
        add_bounded(bounds, axis, least - n[6]);
        add_bounded(bounds, axis + 2, most + n[6]);
    }
    return bounds;
}

std::optional<Bounds> around_a_line(std::span<const double> n) {
    if (!within_the_map(n.first(7)) || n[6] < 0) return {};
    Arguments arguments;
    std::ranges::copy(n, arguments.numbers.begin());
    if (truth::least_sine(truth::triangle_of(arguments)) >= truth::parallel / 2) return {};
    const std::array<dvec2, 3> corners{dvec2(n[0], n[1]), dvec2(n[2], n[3]), dvec2(n[4], n[5])};
    std::array<double, 3> lengths{};
    for (std::size_t k = 0; k < 3; ++k) lengths[k] = glm::length(corners[(k + 1) % 3] - corners[k]);
    const auto edge = static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
    const double longest = lengths[edge];
    if (longest > 0 &&
        std::ranges::count_if(lengths, [&](double l) { return l > (1 - 0x1p-18) * longest; }) > 1)
        return {};
    const dvec2 from = corners[edge];
    const dvec2 along = longest > 0 ? (corners[(edge + 1) % 3] - from) / longest : dvec2(1, 0);
    const dvec2 across(-along.y, along.x);
    const double margin = n[6] + 2 * truth::parallel * longest;
    const dvec2 sides(longest + 2 * margin, 2 * margin);
    const auto corner = static_cast<std::uint32_t>(n[7]) % 3;
    dvec2 want = from - margin * along - margin * across;
    if (corner == 1) want += 2 * sides.x * along;
    if (corner == 2) want += 2 * sides.y * across;
    const double off = 0x1p-20 * (glm::length(from) + longest + margin);
    return Bounds{{want.x - off, want.y - off}, {want.x + off, want.y + off}};
}

std::optional<Bounds> left_of_the_edge(std::span<const double> n) {
    if (!within_the_map(n) || (n[0] == n[2] && n[1] == n[3])) return {};
    const bool at_its_beginning = n[4] == n[0] && n[5] == n[1];
    const bool along_x = n[1] == n[3] && n[5] == n[1], along_y = n[0] == n[2] && n[4] == n[0];
    if (!at_its_beginning && !along_x && !along_y) return {};
    const double x = n[2] - n[0], y = n[3] - n[1], length = std::hypot(x, y);
    if (length < 0x1p-100) return {};
    const double off = 0x1p-22;
    return Bounds{{-y / length - off, x / length - off}, {-y / length + off, x / length + off}};
}

std::optional<Bounds> first_corner(std::span<const double> n) {
    const std::span corners = n.first(6);
    if (within_the_map(corners)) {
        Arguments arguments;
        std::ranges::copy(n, arguments.numbers.begin());
        if (truth::least_sine(truth::triangle_of(arguments)) >= truth::parallel / 2) return {};
    } else if (std::ranges::all_of(corners, [](double x) { return std::isfinite(x); })) {
        return {};
    }
    Bounds bounds;
    for (std::size_t axis = 0; axis < 2; ++axis) add_bounded(bounds, axis, n[axis]);
    return bounds;
}

Bounds near_the_plane(std::span<const double> n, const Truth& truth) {
    double off = 0;
    if (truth::least_sine(truth::Triangle<double>{{{n[0], n[1]}, {n[3], n[4]}, {n[6], n[7]}}}) >=
        truth::parallel)
        off = 0x1p-21 * DepthTerms(n, {}).most + DepthTerms::underflow;
    const double z = truth.value[0];
    const auto to_float = [](double x) { return std::clamp<double>(x, -FLT_MAX, FLT_MAX); };
    return of_either_sign({{to_float(z - off)}, {to_float(z + off)}});
}

Bounds around_the_plane(std::span<const double> n, const Truth& truth) {
    const auto [least, most] = std::minmax({n[2], n[5], n[8]});
    if (truth::least_sine(truth::Triangle<double>{{{n[0], n[1]}, {n[3], n[4]}, {n[6], n[7]}}}) <
        truth::parallel)
        return of_either_sign(exactly({least, most}));
    const DepthTerms terms(n, {n[11], n[12]});
    const double some = 0x1p-21 * terms.least - DepthTerms::underflow;
    const double much = 3 * 0x1p-21 * terms.most + DepthTerms::underflow;
    if (!(much < 0x1p100)) return of_either_sign({{least, least}, {most, most}});
    // A truth at the other end of the range may lie anywhere beyond it.
    const double near_end = truth.value[0], far_end = truth.value[1];
    Bounds bounds;
    bounds.lower[0] = std::max(near_end - much, least);
    bounds.upper[0] = near_end < most ? std::max(near_end - some, least) : most;
    bounds.lower[1] = far_end > least ? std::min(far_end + some, most) : least;
    bounds.upper[1] = std::min(far_end + much, most);
    return of_either_sign(bounds);
}

std::optional<Bounds> anywhere_between(std::span<const double> n) {
    if (!within_the_map(n.first(9))) return {};
    const auto [least, most] = std::minmax({n[2], n[5], n[8]});
    if (!std::ranges::all_of(n.subspan(9), [](double x) { return std::isfinite(x); }))
        return of_either_sign(exactly({least, most}));
    if (!within_the_map(n) || (n[11] >= 0 && n[12] >= 0)) return {};
    Arguments arguments;
    std::ranges::copy(n, arguments.numbers.begin());
    if (!truth::is_clear(truth::least_sine(truth::triangle_of(arguments, 0, 3)))) return {};
    for (const std::size_t i : {11u, 12u}) arguments.numbers[i] = std::abs(arguments.numbers[i]);
    return around_the_plane(std::span(arguments.numbers).first(n.size()), truth::depth_bounds(arguments));
}

} // namespace gnomon::hybrid
