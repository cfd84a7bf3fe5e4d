// The table of kernels/column: what is certain of a ray towards the light, or of a texel's square, and a
// triangle in the light's view, when neither is known better than to a margin.
//
// References say where an answer lies that is exactly what margins ask for; kernels may round. So yes and no
// are compared where coordinates wrong by 2^-20 of the largest would not change the answer, 16 roundings.
// That kernels are never certain and wrong has no such exception, and is tested exactly:
// tests/hybrid_kernels/column_test.cpp.
#include "casegen/reference/hybrid/column.h"
#include "casegen/catalogue.h"
#include "casegen/hybrid/triangles.h"
#include "casegen/reference/hybrid/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// --- references
// ------------------------------------------------------------------------------------------------------

bool overlaps(dvec2 a, dvec2 b, dvec2 c, dvec2 centre, double half_side) {
    return truth::meets_square({place(a), place(b), place(c)}, place(centre), half_side);
}
bool overlaps_clearly(const Arguments& arguments) {
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
    const Place a = place_at(arguments, 0), b = place_at(arguments, 2), centre = place_at(arguments, 4);
    const double half = arguments.numbers[6], off = rounding(arguments, {0, 1, 2, 3, 4, 5, 6});
    return truth::segment_meets_square(a, b, centre, half + off) ==
           truth::segment_meets_square(a, b, centre, half - off);
}

bool opposite(dvec2 a, dvec2 b, dvec2 c, dvec2 d, double margin) {
    return truth::are_opposite(place(a), place(b), place(c), place(d), margin);
}
/// It may give up early, but not before margins are four times as large.
bool opposite_clearly(const Arguments& arguments) {
    const double margin = arguments.numbers[8], off = rounding(arguments, {0, 1, 2, 3, 4, 5, 6, 7});
    const auto with = [&](double by) {
        return truth::are_opposite(place_at(arguments, 0), place_at(arguments, 2), place_at(arguments, 4),
                                   place_at(arguments, 6), std::max(by, 0.0));
    };
    return margin >= 0 && with(margin - off) == with(4 * margin + off);
}

unsigned coverage(dvec2 a, dvec2 b, dvec2 c, dvec2 p, double margin) {
    return truth::coverage({place(a), place(b), place(c)}, place(p), margin);
}
bool covers_clearly(const Arguments& arguments) {
    return truth::is_clear_coverage(truth::triangle_of(arguments), place_at(arguments, 6),
                                    arguments.numbers[8], rounding(arguments, {0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

/// The margin is no less than the rounding of corners as seen from the point, as the pipeline's is: who
/// rounds takes it for that, and from farther away a triangle looks too thin for a plane, whatever it is.
bool is_asked_near(const Arguments& arguments, std::size_t margin) {
    double farthest = 0;
    for (std::size_t corner = 0; corner < 9; corner += 3)
        for (std::size_t axis = 0; axis < 2; ++axis)
            farthest =
                std::max(farthest, std::abs(arguments.numbers[corner + axis] - arguments.numbers[9 + axis]));
    return farthest * 0x1p-24 <= arguments.numbers[margin];
}

unsigned height(dvec3 a, dvec3 b, dvec3 c, dvec3 origin, double tmin, double margin, double margin_z) {
    return truth::height(solid(a, b, c), {origin.x, origin.y}, origin.z - tmin, margin, margin_z);
}
bool is_high_clearly(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const truth::Solid triangle = solid_of(arguments);
    if (!is_asked_near(arguments, 13) || truth::has_plane(triangle, n[13]) == 2) return false;
    const double across = rounding(arguments, {0, 1, 3, 4, 6, 7, 9, 10, 13}),
                 along = rounding(arguments, {2, 5, 8, 11, 12, 14});
    const auto with = [&](double sign) {
        return truth::height(triangle, place_at(arguments, 9), n[11] - n[12], n[13], n[14] + sign * along,
                             sign * across);
    };
    return with(1) == with(-1);
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

bool has_plane(const Arguments& arguments) {
    return is_asked_near(arguments, 12) && truth::has_plane(solid_of(arguments), arguments.numbers[12]) == 1;
}
bool has_plane_or_none(const Arguments& arguments) {
    return is_asked_near(arguments, 12) && truth::has_plane(solid_of(arguments), arguments.numbers[12]) != 2;
}

// --- inputs
// ----------------------------------------------------------------------------------------------------------

/// Triangles, with a margin at `margin`: as small as roundings of the coordinates, which is what the pipeline
/// asks for, or as large as the triangles.
std::shared_ptr<const Generator> with_margin(const char* name, const hybrid::Layout& layout,
                                             std::size_t margin, std::size_t margin_z = 0) {
    auto generator = std::make_shared<Generator>(*hybrid::triangles(name, layout));
    const auto small = [layout, margin, margin_z](Random& random, std::span<double> numbers) {
        double largest = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 2; ++k)
                largest = std::max(largest, std::abs(numbers[i * layout.stride + k]));
        numbers[margin] = largest * std::exp2(-24 + 3 + 10 * random.unit());
        if (margin_z != 0) numbers[margin_z] = std::exp2(-24 + 3 + 10 * random.unit());
    };
    generator->draw = [draw = generator->draw, small](Random& random, std::span<double> numbers) {
        draw(random, numbers);
        if (random.chance(0.75)) small(random, numbers);
    };
    return generator;
}

std::shared_ptr<const Generator> segments() {
    auto generator = std::make_shared<Generator>();
    generator->name = "column/segments";
    generator->draw = [](Random& random, std::span<double> n) {
        const double size = std::exp2(-13 + 30 * random.unit());
        for (std::size_t i = 0; i < 6; ++i) n[i] = size * (2 * random.unit() - 1);
        n[6] = size * std::exp2(-10 * random.unit());
        if (random.chance(0.2)) n[2] = n[0]; // along an axis
        if (random.chance(0.1)) n[3] = n[1]; // or of no length
    };
    generator->loci.push_back(
        {"through the square's corner", "corners", [](Random& random, double distance, std::span<double> n) {
             // b behind the corner as seen from a, a little off.
             const double off = 1 + distance * (2 * random.unit() - 1);
             const double x = n[4] + (random.chance(0.5) ? n[6] : -n[6]) * off,
                          y = n[5] + (random.chance(0.5) ? n[6] : -n[6]) * off;
             const double t = 1 + random.unit();
             n[2] = n[0] + t * (x - n[0]), n[3] = n[1] + t * (y - n[1]);
         }});
    return generator;
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
    const hybrid::Layout over_ray{
        .stride = 3, .points = {9}, .extents = {12, 13, 14}, .depths = {2, 5, 8, 11}};
    const hybrid::Layout over_square{.stride = 3, .points = {9}, .extents = {11, 12}, .depths = {2, 5, 8}};
    const auto rays = with_margin("column/rays", over_ray, 13, 14);
    const auto squares = with_margin("column/squares", over_square, 12);
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
                .generator = hybrid::triangles("column/overlaps", {.points = {6}, .extents = {8}}),
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
                .generator = segments(),
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
                .generator = with_margin("column/opposite", {.points = {6}, .extents = {8}}, 8),
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
                .generator = with_margin("column/coverage", {.points = {6}, .extents = {8}}, 8),
                .rule = "of NaN nothing is certain: an edge with it is unsure",
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
                // Differences, products and a quotient: no more than 16 roundings of any input.
                .tolerance = conditioned(16),
                .where = has_plane,
                .generator = squares,
                .rule = "too thin for its margin, or not finite: depth 0, wrong by infinity",
            },
            {
                .name = "column/depth_bounds",
                .source = "docs/hybrid.md, why the sound classifiers are sound: depth",
                .reference = reference_by<dvec2(dvec3, dvec3, dvec3, dvec2, double, double)>(
                    truth::column_depth_bounds),
                .parameters = deep({across("centre", square), length("half_side", "texels", "half its side"),
                                    margin("how far corners may be from their true places")}),
                .result = {-infinity, infinity, "world", "nearest and farthest over the square"},
                .tolerance = conditioned(16),
                .where = has_plane_or_none,
                .generator = squares,
                .rule = "too thin for a plane: the nearest and the farthest corner; corners that are NaN are "
                        "left out, and of none at all nothing is certain: -infinity and infinity",
            },
            {
                .name = "column/height",
                .source = "docs/hybrid.md, why the sound classifiers are sound: the ray",
                .reference = height,
                .parameters = deep(ray()),
                .result = {0, 2, "1", "0 certainly not above the origin, 1 certainly, 2 unsure"},
                .where = is_high_clearly,
                .generator = rays,
                .rule = unsure,
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
