// The table of kernels/conservative: triangles grown and shrunken by half a texel's diagonal, and their
// depths over a texel.
#include "casegen/catalogue.h"
#include "casegen/hybrid/conservative_bounds.h"
#include "casegen/hybrid/conservative_inputs.h"
#include "casegen/hybrid/triangles.h"
#include "casegen/reference/hybrid/truth.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace gnomon {
namespace {

namespace truth = reference::hybrid;
using glm::dvec2, glm::dvec3, glm::dvec4;

Parameter point(const char* name, const char* meaning) {
    return {name, {-hybrid::farthest, hybrid::farthest, {}}, "map", meaning};
}
std::vector<Parameter> triangle() {
    return {point("a", "the triangle's corners, in the light's view"), point("b", "the second"),
            point("c", "the third")};
}
std::vector<Parameter> and_lambda(std::vector<Parameter> parameters) {
    parameters.push_back(
        {"lambda", {0, hybrid::farthest, {}}, "map", "how far edges move: half a texel's diagonal"});
    return parameters;
}
std::vector<Parameter> and_corner(std::vector<Parameter> parameters) {
    parameters.push_back({"corner", {0, 2, {}}, "1", "the corner's number"});
    return parameters;
}
std::vector<Parameter> in_depth(std::vector<Parameter> more) {
    std::vector<Parameter> parameters = triangle();
    for (Parameter& each : parameters) each.meaning += ", and its depth";
    for (Parameter& each : more) parameters.push_back(std::move(each));
    return parameters;
}

const char* const or_zero =
    "an input that is not finite gives a finite answer, what overflows the largest float";

double least_sine(const Arguments& arguments, std::size_t stride = 2) {
    return truth::least_sine(truth::triangle_of(arguments, 0, stride));
}
bool is_broad(const Arguments& arguments) { return truth::is_broad(least_sine(arguments)); }
bool is_clear_in_depth(const Arguments& arguments) { return truth::is_clear(least_sine(arguments, 3)); }

/// What erosion by lambda leaves of a triangle's size: 1 - lambda / (inscribed radius). Its edges shrink
/// alike.
struct Left {
    double sine, share, shortest, lambda, off;
    explicit Left(const Arguments& arguments) {
        const truth::Triangle<double> t = truth::triangle_of(arguments);
        const double lengths[] = {truth::length(t[0], t[1]), truth::length(t[1], t[2]),
                                  truth::length(t[2], t[0])};
        sine = truth::least_sine(t);
        shortest = *std::min_element(std::begin(lengths), std::end(lengths));
        lambda = arguments.numbers[6];
        const double moved =
            lambda * (lengths[0] + lengths[1] + lengths[2]) / std::abs(truth::area2(t[0], t[1], t[2]));
        share = 1 - moved;
        // Corners are good to 2^-21 of the triangle over its least sine.
        off = 0x1p-19 / sine * *std::max_element(std::begin(lengths), std::end(lengths)) * (1 + moved);
    }
    bool erodes() const { return sine > truth::parallel && share > 0; }
    bool erodes_as_published() const { return erodes() && share * shortest >= 2 * lambda; }
    /// Whether that decides nothing.
    bool is_clear() const {
        return sine < truth::parallel / 2 || (truth::is_broad(sine) && std::abs(share) * shortest > off);
    }
    bool is_clear_as_published() const {
        return is_clear() && (!erodes() || std::abs(share * shortest - 2 * lambda) > off + 0x1p-20 * lambda);
    }
};
Arguments triangle_arguments(dvec2 a, dvec2 b, dvec2 c, double lambda) {
    Arguments arguments;
    arguments.numbers = {a.x, a.y, b.x, b.y, c.x, c.y, lambda};
    return arguments;
}
bool erodes(dvec2 a, dvec2 b, dvec2 c, double lambda) {
    return Left(triangle_arguments(a, b, c, lambda)).erodes();
}
bool erodes_as_published(dvec2 a, dvec2 b, dvec2 c, double lambda) {
    return Left(triangle_arguments(a, b, c, lambda)).erodes_as_published();
}
bool is_clear_erosion(const Arguments& arguments) { return Left(arguments).is_clear(); }
bool is_clear_as_published(const Arguments& arguments) { return Left(arguments).is_clear_as_published(); }

bool in_clip_box(dvec2 p, dvec4 box) {
    return glm::clamp(p.x, box.x, box.z) == p.x && glm::clamp(p.y, box.y, box.w) == p.y && box.x <= box.z &&
           box.y <= box.w;
}

} // namespace

Family conservative_family() {
    const Result where_to{-FLT_MAX, FLT_MAX, "map", "a point"};
    const auto with_lambda = hybrid::triangles("conservative/triangle", {.distance = 6});
    const auto with_corner = hybrid::triangles("conservative/corner", {.distance = 6, .counts = {{7, 2}}});
    std::vector<Parameter> lines = triangle();
    lines = {point("a", "a point of the first line"), point("b", "another"),
             point("c", "a point of the second line"), point("d", "another"),
             point("otherwise", "the answer where they are parallel")};
    return {
        "conservative",
        "triangles moved out and in by half a texel's diagonal, and their depths over a texel",
        {
            {
                .name = "conservative/line_intersection",
                .source = "Hybrid hard shadows, 2.2.1, lineLineIntersection",
                .reference = reference_by<dvec2(dvec2, dvec2, dvec2, dvec2, dvec2)>(truth::line_intersection),
                .parameters = lines,
                .result = where_to,
                .tolerance = conditioned(8), // not derived: gnomon worst finds no more than 6.5
                .where = [](const Arguments& a) { return truth::is_clear(truth::sine_between(a)); },
                .generator = hybrid::pairs_of_lines(),
                .rule = or_zero,
            },
            {
                .name = "conservative/inward",
                .source = "Hybrid hard shadows, equation 2, corrected",
                .reference = reference_by<dvec2(dvec2, dvec2, dvec2)>(truth::inward),
                .parameters = {point("a", "where the edge begins"), point("b", "where it ends"),
                               point("inside", "a point on its inner side")},
                .result = {-1, 1, "1", "unit normal"},
                .tolerance = conditioned(8),
                .where =
                    [](const Arguments& a) {
                        const auto& n = a.numbers;
                        return is_broad(a) || (n[0] == n[2] && n[1] == n[3]); // or no edge at all
                    },
                .generator = hybrid::triangles("conservative/inward", {}),
                .rule =
                    "an edge without length has none, (0, 0); where `inside` is on the edge's line, its left",
                .outside = hybrid::left_of_the_edge,
            },
            {
                .name = "conservative/dilated",
                .source = "Hybrid hard shadows, 2.2, equation 3; Hasselgren et al. 2005",
                .reference = reference_by<dvec2(dvec2, dvec2, dvec2, double, unsigned)>(truth::dilated),
                .parameters = and_corner(and_lambda(triangle())),
                .result = where_to,
                .tolerance = conditioned(8),
                .where = is_broad,
                .generator = with_corner,
                .rule =
                    "a triangle that is a line to within rounding: one over twice the rectangle around it",
                .outside = hybrid::around_a_line,
            },
            {
                .name = "conservative/clip_box",
                .source = "Hybrid hard shadows, figure 8; Hasselgren et al. 2005",
                .reference = reference_by<dvec4(dvec2, dvec2, dvec2, double)>(truth::clip_box),
                .parameters = and_lambda(triangle()),
                .result = {-FLT_MAX, FLT_MAX, "map", "smallest x and y, largest x and y"},
                .tolerance = conditioned(1),
                .generator = with_lambda,
                .rule = or_zero,
                .outside = hybrid::clip_box_beyond,
            },
            {
                .name = "conservative/in_clip_box",
                .source = "Hybrid hard shadows, figure 8; Hasselgren et al. 2005",
                .reference = in_clip_box,
                .parameters = {{"p", {-2, 2, {}}, "map", "a point"},
                               {"box", {-2, 2, {}}, "map", "smallest x and y, largest x and y"}},
                .result = {0, 1, "1", "whether the point is in the box"},
                .generator = hybrid::points_and_boxes(),
                .rule = "a box that ends before it begins holds nothing, nor does one of NaN",
            },
            {
                .name = "conservative/eroded",
                .source = "Hybrid hard shadows, 2.2, equation 3; Hasselgren et al. 2005",
                .reference = reference_by<dvec2(dvec2, dvec2, dvec2, double, unsigned)>(truth::eroded),
                .parameters = and_corner(and_lambda(triangle())),
                .result = where_to,
                .tolerance = conditioned(8),
                .where = is_broad,
                .generator = with_corner,
                .rule = "a triangle that is a line to within rounding shrinks to its first corner",
                .outside = hybrid::first_corner,
            },
            {
                .name = "conservative/erodes",
                .source = "Hybrid hard shadows, 2.2; docs/decisions.md H12",
                .reference = erodes,
                .parameters = and_lambda(triangle()),
                .result = {0, 1, "1", "whether anything is left"},
                .where = is_clear_erosion,
                .generator = with_lambda,
                .rule = "nothing is left of a line, nor of what is not finite",
                .outside = hybrid::no_if_not_finite,
            },
            {
                .name = "conservative/erodes_as_published",
                .source = "Hybrid hard shadows, chapter 4; docs/decisions.md H12",
                .reference = erodes_as_published,
                .parameters = and_lambda(triangle()),
                .result = {0, 1, "1", "whether anything is left"},
                .where = is_clear_as_published,
                .generator = with_lambda,
                .rule = "nothing is left of a line, nor of what is not finite",
                .outside = hybrid::no_if_not_finite,
            },
            {
                .name = "conservative/tight_offset",
                .source = "Hasselgren et al. 2005",
                .reference = reference_by<double(dvec2, dvec2)>(truth::tight_offset),
                .parameters = {{"normal", {-1, 1, {}}, "1", "the edge's unit normal"},
                               {"texel", {0, 2, {}}, "map", "the texel's width and height"}},
                .result = {0, FLT_MAX, "map", "how far the edge must move"},
                .tolerance = conditioned(2),
                .generator = hybrid::normals_and_texels(),
                .rule = or_zero,
            },
            {
                .name = "conservative/depth_at",
                .source = "Hybrid hard shadows, 2.2.1; docs/hybrid.md",
                .reference = reference_by<double(dvec3, dvec3, dvec3, dvec2)>(truth::depth_at),
                .parameters = in_depth({point("p", "a point of the map")}),
                .result = {-FLT_MAX, FLT_MAX, "light depth", "the plane's depth there"},
                .tolerance = conditioned(8),
                .where = is_clear_in_depth,
                .generator = hybrid::depths_in_triangles("conservative/depth_at", false),
                .rule = "edge-on: the nearest corner's depth",
                .within = hybrid::near_the_plane,
            },
            {
                .name = "conservative/depth_bounds",
                .source = "Hybrid hard shadows, chapter 4; docs/decisions.md H14",
                .reference = reference_by<dvec2(dvec3, dvec3, dvec3, dvec2, dvec2)>(truth::depth_bounds),
                .parameters = in_depth(
                    {point("p", "the texel's centre"),
                     {"half_texel", {0, hybrid::farthest, {}}, "map", "half the texel's width and height"}}),
                .result = {-FLT_MAX, FLT_MAX, "light depth", "nearest and farthest"},
                // It adds 2^-20 of all terms, 16 roundings of each, so as to be a bound whatever is rounded;
                // there are a few times more terms than inputs.
                .tolerance = conditioned(64),
                .where = is_clear_in_depth,
                .generator = hybrid::depths_in_triangles("conservative/depth_bounds", true),
                .rule = "edge-on, or over a texel that is not finite: the nearest and the farthest corner's "
                        "depth",
                .outside = hybrid::anywhere_between,
                .within = hybrid::around_the_plane,
            },
        }};
}

} // namespace gnomon
