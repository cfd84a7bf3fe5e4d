// The table of kernels/column: what is certain of a ray towards the light, or of a texel's square, and a
// triangle in the light's view, when neither is known better than to a margin.
//
// References say where an answer lies that is exactly what margins ask for, and the least margins that
// kernels take; kernels may round. So yes and no are compared where coordinates wrong by 2^-20 of the largest
// would not change the answer, 16 roundings, or where no float that a sum may be rounded to would.
// That kernels are never certain and wrong has no such exception, and is tested exactly:
// tests/hybrid_kernels/column_test.cpp.
#include "casegen/reference/hybrid/column.h"
#include "casegen/catalogue.h"
#include "casegen/hybrid/column_inputs.h"
#include "casegen/hybrid/triangles.h"
#include "casegen/reference/hybrid/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace gnomon {
namespace {

namespace truth = reference::hybrid;
using glm::dvec2, glm::dvec3, glm::dvec4;
using truth::Place;

constexpr double infinity = std::numeric_limits<double>::infinity();

Place place(dvec2 p) { return {p.x, p.y}; }
Place place_at(const Arguments& arguments, std::size_t i) {
    return {arguments.numbers[i], arguments.numbers[i + 1]};
}
truth::Solid solid(dvec3 a, dvec3 b, dvec3 c) {
    return {{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
}
truth::Solid solid_of(const Arguments& arguments) {
    truth::Solid result;
    for (std::size_t i = 0; i < 9; ++i) result[i / 3][i % 3] = arguments.numbers[i];
    return result;
}

/// 16 roundings of the largest of some coordinates; and never so little that their products vanish.
double rounding(const Arguments& arguments, std::initializer_list<std::size_t> which) {
    double largest = 0;
    for (const std::size_t i : which) largest = std::max(largest, std::abs(arguments.numbers[i]));
    return 0x1p-20 * largest + 0x1p-50;
}

/// Whether all are whole multiples of a power of two, and no more than 64 of them: products of differences
/// are floats then, and what does not touch is farther away than doubles round. Not of numbers so small that
/// such products are not.
bool is_on_coarse_grid(const Arguments& arguments, std::size_t count) {
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, std::abs(arguments.numbers[i]));
    const double unit = std::exp2(std::ceil(std::log2(largest)) - 6);
    if (largest == 0) return true;
    return unit >= 0x1p-50 && std::ranges::all_of(std::span(arguments.numbers).first(count), [&](double x) {
               return std::nearbyint(x / unit) == x / unit;
           });
}

bool overlaps(dvec2 a, dvec2 b, dvec2 c, dvec2 centre, double half_side) {
    return truth::meets_square({place(a), place(b), place(c)}, place(centre), half_side);
}
bool overlaps_clearly(const Arguments& arguments) {
    if (is_on_coarse_grid(arguments, 9)) return true;
    const truth::Triangle<double> triangle = truth::triangle_of(arguments);
    const double half = arguments.numbers[8], off = rounding(arguments, {0, 1, 2, 3, 4, 5, 6, 7, 8});
    const Place centre = place_at(arguments, 6);
    return truth::meets_square(triangle, centre, half + off) ==
           truth::meets_square(triangle, centre, half - off);
}

bool touches(dvec2 a, dvec2 b, dvec2 centre, double half_side) {
    return truth::segment_meets_square(place(a), place(b), place(centre), half_side);
}
bool touches_clearly(const Arguments& arguments) {
    if (is_on_coarse_grid(arguments, 7)) return true;
    const Place a = place_at(arguments, 0), b = place_at(arguments, 2), centre = place_at(arguments, 4);
    const double half = arguments.numbers[6], off = rounding(arguments, {0, 1, 2, 3, 4, 5, 6});
    return truth::segment_meets_square(a, b, centre, half + off) ==
           truth::segment_meets_square(a, b, centre, half - off);
}

bool opposite(dvec2 a, dvec2 b, dvec2 c, dvec2 d, double margin) {
    return truth::are_opposite(place(a), place(b), place(c), place(d), margin);
}
bool opposite_clearly(const Arguments& arguments) {
    return truth::is_clear_opposite(place_at(arguments, 0), place_at(arguments, 2), place_at(arguments, 4),
                                    place_at(arguments, 6), arguments.numbers[8]);
}

unsigned coverage(dvec2 a, dvec2 b, dvec2 c, dvec2 p, double margin) {
    return truth::coverage({place(a), place(b), place(c)}, place(p), margin);
}
bool covers_clearly(const Arguments& arguments) {
    return truth::is_clear_coverage(truth::triangle_of(arguments), place_at(arguments, 6),
                                    arguments.numbers[8], rounding(arguments, {0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

unsigned height(dvec3 a, dvec3 b, dvec3 c, dvec3 origin, double tmin, double margin, double margin_z) {
    return truth::height(solid(a, b, c), {origin.x, origin.y}, origin.z, tmin, margin, margin_z);
}
bool is_high_clearly(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    return truth::is_clear_height(solid_of(arguments), place_at(arguments, 9), n[11], n[12], n[13], n[14],
                                  rounding(arguments, {0, 1, 3, 4, 6, 7, 9, 10, 13}),
                                  rounding(arguments, {2, 5, 8, 11, 12, 14}));
}

unsigned hit(dvec3 a, dvec3 b, dvec3 c, dvec3 origin, double tmin, double margin, double margin_z) {
    const unsigned over = coverage(dvec2(a), dvec2(b), dvec2(c), dvec2(origin), margin);
    if (over == 8) return 0;
    const unsigned above = height(a, b, c, origin, tmin, margin, margin_z);
    return above == 0 ? 0 : above == 1 && over == 0 ? 1 : 2;
}
bool hits_clearly(const Arguments& arguments) {
    return is_high_clearly(arguments) &&
           truth::is_clear_coverage(truth::triangle_of(arguments, 0, 3), place_at(arguments, 9),
                                    arguments.numbers[13],
                                    rounding(arguments, {0, 1, 3, 4, 6, 7, 9, 10, 13}));
}

unsigned known_plane(const Arguments& arguments) {
    return truth::has_plane(solid_of(arguments), place_at(arguments, 9), arguments.numbers[12]);
}
bool has_plane(const Arguments& arguments) { return known_plane(arguments) == 1; }
bool has_plane_or_none(const Arguments& arguments) { return known_plane(arguments) != 2; }

/// Whether the area of a triangle, in its sides' coordinates as floats, is none: beyond the largest float by
/// more than what adding two products is rounded by. Of one product that is half its last place.
bool has_no_area(std::span<const double> n) {
    const auto side = [&](std::size_t from, std::size_t to, std::size_t axis) {
        return static_cast<double>(static_cast<float>(n[to + axis] - n[from + axis]));
    };
    const double down = side(0, 3, 0) * side(6, 0, 1), up = side(0, 3, 1) * side(6, 0, 0);
    const double largest = static_cast<double>(std::numeric_limits<float>::max());
    return std::abs(up - down) >= (up == 0 || down == 0 ? 1 + 0x1p-25 : 1 + 0x1p-20) * largest;
}

/// No plane: of what is not finite, of a triangle too thin for its margin, nor where its area or the depth is
/// no float.
std::optional<Bounds> no_plane(std::span<const double> n) {
    const Bounds none = exactly({0, 0, 0, infinity});
    if (n[11] < 0) return {};
    const auto finite = [](double x) { return std::isfinite(x); };
    if (!std::ranges::all_of(n.first(12), finite) || std::isnan(n[12]) || n[12] == infinity) return none;
    Arguments arguments;
    std::ranges::copy(n, arguments.numbers.begin());
    if (n[12] < 0) arguments.numbers[12] = 0; // there is a least margin
    const double largest = static_cast<double>(std::numeric_limits<float>::max());
    if (known_plane(arguments) == 0 || has_no_area(n) ||
        std::abs(truth::column_plane(arguments).value[2]) > 2 * largest)
        return none;
    return {};
}

/// Of a margin that is NaN no edge is sure, whether or not the point is near the triangle.
std::optional<Bounds> all_unsure(std::span<const double> n) {
    const auto near = [](double x) { return std::abs(x) <= hybrid::farthest; };
    if (std::isnan(n[8]) && std::ranges::all_of(n.first(8), near)) return exactly({7});
    return {};
}

/// Nor is any depth known to within a margin that is NaN.
std::optional<Bounds> never_certain(std::span<const double> n) {
    if (!std::isnan(n[14])) return {};
    return exactly({2});
}

/// Of no depth nothing is certain.
std::optional<Bounds> no_depth(std::span<const double> n) {
    if (!std::isnan(n[2]) || !std::isnan(n[5]) || !std::isnan(n[8])) return {};
    return exactly({-infinity, infinity});
}

Parameter across(const char* name, const char* meaning) {
    return {name, {-hybrid::farthest, hybrid::farthest, {}}, "texels", meaning};
}
Parameter solid_point(const char* name, const char* meaning) {
    return {name, {-hybrid::farthest, hybrid::farthest, {}}, "texels, texels, world", meaning};
}
Parameter length(const char* name, const char* unit, const char* meaning) {
    return {name, {0, hybrid::farthest, {}}, unit, meaning};
}
std::vector<Parameter> flat(std::vector<Parameter> more) {
    std::vector<Parameter> all{across("a", "the triangle's corners, in the light's view"),
                               across("b", "the second"), across("c", "the third")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}
std::vector<Parameter> deep(std::vector<Parameter> more) {
    std::vector<Parameter> all{solid_point("a", "the triangle's corners, and their depths"),
                               solid_point("b", "the second"), solid_point("c", "the third")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}
Parameter margin(const char* meaning) { return length("margin", "texels", meaning); }
std::vector<Parameter> ray() {
    return {solid_point("origin", "where the ray begins"),
            length("tmin", "world", "nearer to the origin than this nothing is hit"),
            margin("how far places across the light may be from the true ones"),
            length("margin_z", "world", "how far depths may be")};
}

const char* const square = "the middle of the square";
const char* const unsure = "what is not finite makes it unsure or is left out; never anything but 0, 1, 2";

} // namespace

Family column_family() {
    const auto rays = hybrid::triangles_and_rays();
    const auto squares = hybrid::planes();
    return {
        "column",
        "what is certain of a triangle and a ray towards the light, or a texel's square, to within margins",
        {
            {
                .name = "column/overlaps",
                .source = "docs/hybrid.md, why the sound classifiers are sound: the column",
                .reference = overlaps,
                .parameters =
                    flat({across("centre", square), length("half_side", "texels", "half its side")}),
                .result = {0, 1, "1", "whether the triangle meets the square"},
                .where = overlaps_clearly,
                .generator = hybrid::triangles_and_squares(),
                .rule = "NaN separates nothing: it may say true of what it has no place for",
            },
            {
                .name = "column/touches",
                .source = "docs/hybrid.md, why the sound classifiers are sound: sheets",
                .reference = touches,
                .parameters = {across("a", "where the segment begins"), across("b", "where it ends"),
                               across("centre", square), length("half_side", "texels", "half its side")},
                .result = {0, 1, "1", "whether the segment meets the square"},
                .where = touches_clearly,
                .generator = hybrid::segments(),
                .rule = "NaN separates nothing",
            },
            {
                .name = "column/opposite",
                .source = "docs/hybrid.md, why the sound classifiers are sound: sheets",
                .reference = opposite,
                .parameters = {across("a", "a point of the line"), across("b", "another"),
                               across("c", "a point on one side"), across("d", "one on the other"),
                               margin("how far each may be from its true place, in x and in y")},
                .result = {0, 1, "1", "whether c and d are certainly on opposite sides of ab"},
                .where = opposite_clearly,
                .generator = hybrid::lines_and_points(),
                .rule = "NaN is on no side",
            },
            {
                .name = "column/coverage",
                .source = "docs/hybrid.md, why the sound classifiers are sound: the ray",
                .reference = coverage,
                .parameters = flat({across("p", "a point"),
                                    margin("how far they may be from their true places, in x and in y")}),
                .result = {0, 8, "1", "0 within, 8 outside, else bits of edges: ab 1, bc 2, ca 4"},
                .where = covers_clearly,
                .generator = hybrid::triangles_and_points(),
                .rule = "of NaN nothing is certain: an edge with it is unsure, and all with a margin of it",
                .outside = all_unsure,
            },
            {
                .name = "column/plane",
                .source = "docs/hybrid.md, why the sound classifiers are sound: depth",
                .reference =
                    reference_by<dvec4(dvec3, dvec3, dvec3, dvec2, double, double)>(truth::column_plane),
                .parameters = deep({across("at", "the point that the plane is asked for"),
                                    length("half_side", "texels", "how far from it"),
                                    margin("how far corners may be from their true places")}),
                .result = {-infinity, infinity, "world per texel, world per texel, world, world",
                           "slope along x and y, depth, how wrong it may be within half_side"},
                // Of slopes and error: differences, products and a quotient. Of the depth also what the
                // slopes carry to it, which no conditioning of the depth tells of (truth::plane_roundings).
                .tolerance = conditioned(truth::plane_roundings),
                .where = has_plane,
                .generator = squares,
                .rule = "too thin for its margin, or not finite: depth 0, wrong by infinity",
                .outside = no_plane,
            },
            {
                .name = "column/depth_bounds",
                .source = "docs/hybrid.md, why the sound classifiers are sound: depth",
                .reference = reference_by<dvec2(dvec3, dvec3, dvec3, dvec2, double, double)>(
                    truth::column_depth_bounds),
                .parameters = deep({across("centre", square), length("half_side", "texels", "half its side"),
                                    margin("how far corners may be from their true places")}),
                .result = {-infinity, infinity, "world", "nearest and farthest over the square"},
                .tolerance = conditioned(truth::plane_roundings), // of the plane's depths
                .where = has_plane_or_none,
                .generator = squares,
                .rule = "too thin for a plane: the nearest and the farthest corner; corners that are NaN are "
                        "left out, and of none at all nothing is certain: -infinity and infinity",
                .outside = no_depth,
            },
            {
                .name = "column/height",
                .source = "docs/hybrid.md, why the sound classifiers are sound: the ray",
                .reference = height,
                .parameters = deep(ray()),
                .result = {0, 2, "1", "0 certainly not above the origin, 1 certainly, 2 unsure"},
                .where = is_high_clearly,
                .generator = rays,
                .rule = "what is not finite is left out, but for a margin of depths: then it is unsure",
                .outside = never_certain,
            },
            {
                .name = "column/hit",
                .source = "docs/hybrid.md, why the sound classifiers are sound: the ray",
                .reference = hit,
                .parameters = deep(ray()),
                .result = {0, 2, "1", "0 the ray certainly misses, 1 certainly hits beyond tmin, 2 unsure"},
                .where = hits_clearly,
                .generator = rays,
                .rule = unsure,
            },
        }};
}

} // namespace gnomon
