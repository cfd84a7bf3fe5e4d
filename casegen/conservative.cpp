// The table of kernels/conservative: triangles grown and shrunken by half a texel's diagonal, and their
// depths over a texel.
#include "casegen/catalogue.h"
#include "casegen/hybrid/triangles.h"
#include "casegen/reference/hybrid/truth.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

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
/// Nothing is left of what is not finite.
std::optional<Bounds> no_if_not_finite(std::span<const double> n) {
    if (std::ranges::all_of(n, [](double x) { return std::isfinite(x); })) return {};
    return exactly({0});
}

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
/// Of numbers beyond the map, infinities too. What GLSL's min and max make of NaN is not said.
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

bool in_clip_box(dvec2 p, dvec4 box) {
    return glm::clamp(p.x, box.x, box.z) == p.x && glm::clamp(p.y, box.y, box.w) == p.y && box.x <= box.z &&
           box.y <= box.w;
}

bool within_the_map(std::span<const double> n) {
    return std::ranges::all_of(n, [](double x) { return std::abs(x) <= hybrid::farthest; });
}

/// What stands for a line when it is moved out: a right triangle with legs twice the sides of the rectangle
/// around its longest edge, which reaches `margin` beyond it on all sides. Nothing where another edge is as
/// long to within rounding: either may be taken.
std::optional<Bounds> around_a_line(std::span<const double> n) {
    if (!within_the_map(n.first(7)) || n[6] < 0) return {};
    Arguments arguments;
    std::ranges::copy(n, arguments.numbers.begin());
    if (least_sine(arguments) >= truth::parallel / 2) return {};
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

/// A line has no inner side to speak of: left of its direction is what an axis-parallel edge is asked for
/// when `inside` lies on it, where no product is rounded, or in its first point.
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

/// What a line shrinks to, and what has corners that are no numbers: its first corner.
std::optional<Bounds> first_corner(std::span<const double> n) {
    const std::span corners = n.first(6);
    if (within_the_map(corners)) {
        Arguments arguments;
        std::ranges::copy(n, arguments.numbers.begin());
        if (least_sine(arguments) >= truth::parallel / 2) return {};
    } else if (std::ranges::all_of(corners, [](double x) { return std::isfinite(x); })) {
        return {};
    }
    Bounds bounds;
    for (std::size_t axis = 0; axis < 2; ++axis) add_bounded(bounds, axis, n[axis]);
    return bounds;
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

/// 2^-20 of all terms is twice what rounding does to their sum, wherever the texel lies: half of it.
Bounds near_the_plane(std::span<const double> n, const Truth& truth) {
    double off = 0;
    if (truth::least_sine(truth::Triangle<double>{{{n[0], n[1]}, {n[3], n[4]}, {n[6], n[7]}}}) >=
        truth::parallel)
        off = 0x1p-21 * DepthTerms(n, {}).most + DepthTerms::underflow;
    const double z = truth.value[0];
    const auto to_float = [](double x) { return std::clamp<double>(x, -FLT_MAX, FLT_MAX); };
    return of_either_sign({{to_float(z - off)}, {to_float(z + off)}});
}

/// The plane's depths and that much more on either side: no less than half of it, for half of it rounding may
/// use up; no more than half as much again. Then cut off at the corners' depths. Edge-on exactly these.
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
    const double nearest = truth.value[0], farthest = truth.value[1];
    Bounds bounds;
    bounds.lower[0] = std::max(nearest - much, least);
    bounds.upper[0] = nearest < most ? std::max(nearest - some, least) : most;
    bounds.lower[1] = farthest > least ? std::min(farthest + some, most) : least;
    bounds.upper[1] = std::min(farthest + much, most);
    return of_either_sign(bounds);
}

/// A texel whose extents are negative is as large as one with their magnitudes; over one that is nowhere, or
/// without end, depths are anything between the corners'.
std::optional<Bounds> anywhere_between(std::span<const double> n) {
    if (!within_the_map(n.first(9))) return {};
    const auto [least, most] = std::minmax({n[2], n[5], n[8]});
    if (!std::ranges::all_of(n.subspan(9), [](double x) { return std::isfinite(x); }))
        return of_either_sign(exactly({least, most}));
    if (!within_the_map(n) || (n[11] >= 0 && n[12] >= 0)) return {};
    Arguments arguments;
    std::ranges::copy(n, arguments.numbers.begin());
    if (!is_clear_in_depth(arguments)) return {};
    for (const std::size_t i : {11u, 12u}) arguments.numbers[i] = std::abs(arguments.numbers[i]);
    return around_the_plane(std::span(arguments.numbers).first(n.size()), truth::depth_bounds(arguments));
}

/// Triangles with depths about a level and spread a little or much; points in needles and at corners, texels
/// of all sizes: each term of the sum for a depth is the largest somewhere.
std::shared_ptr<const Generator> depths_generator(const char* name, bool over_texels) {
    const auto triangles = hybrid::triangles(
        name, {.stride = 3,
               .points = {9},
               .extents = over_texels ? std::vector<std::size_t>{11, 12} : std::vector<std::size_t>{},
               .depths = {2, 5, 8}});
    const auto move_point = [over_texels](Random& random, std::span<double> n, dvec3 weights) {
        n[9] = weights.x * n[0] + weights.y * n[3] + weights.z * n[6];
        n[10] = weights.x * n[1] + weights.y * n[4] + weights.z * n[7];
        const double share = std::exp2(-16 * random.unit());
        for (std::size_t i = 11; over_texels && i < 13; ++i) n[i] *= share;
    };
    auto generator = std::make_shared<Generator>(*triangles);
    generator->draw = [=](Random& random, std::span<double> n) {
        triangles->draw(random, n);
        const double level = random.chance(0.5) ? 0 : 2 * random.unit() - 1;
        const double spread = std::exp2(-12 * random.unit());
        for (const std::size_t i : {2u, 5u, 8u}) n[i] = level + spread * (2 * n[i] - 1);
        if (random.chance(0.5)) return;
        const std::size_t corner = random.below(3);
        if (random.chance(0.5)) n[3 * corner + 2] *= std::exp2(-20 * random.unit());
        const double near = random.chance(0.25) ? 0 : std::exp2(-20 * random.unit()), u = random.unit();
        dvec3 weights(near * u, near * (1 - u), near * u);
        weights[static_cast<int>(corner)] = 0;
        weights[static_cast<int>(corner)] = 1 - weights.x - weights.y - weights.z;
        move_point(random, n, weights);
    };
    for (std::size_t turn = 0; turn < 3; ++turn)
        generator->loci.push_back(
            {"points in a needle", "slivers", [=](Random& random, double distance, std::span<double> n) {
                 // The corners' places turned, so that each edge is the longest somewhere.
                 const std::size_t a = 3 * turn, b = 3 * ((turn + 1) % 3), c = 3 * ((turn + 2) % 3);
                 const double x = n[b] - n[a], y = n[b + 1] - n[a + 1];
                 const double t = random.chance(0.5) ? random.unit() : 1 - 2 * distance * random.unit();
                 const double side = random.chance(0.5) ? -distance : distance;
                 n[c] = std::clamp(n[a] + t * x - side * y, -hybrid::farthest, hybrid::farthest);
                 n[c + 1] = std::clamp(n[a + 1] + t * y + side * x, -hybrid::farthest, hybrid::farthest);
                 // Some rise along the needle alone.
                 if (random.chance(0.5)) n[c + 2] = n[a + 2] + t * (n[b + 2] - n[a + 2]);
                 const double u = random.unit(), v = random.unit();
                 move_point(random, n, {(1 - u) * (1 - v), u * (1 - v), v});
                 for (std::size_t i = 11; over_texels && i < 13; ++i)
                     if (random.chance(0.5)) n[i] *= distance;
             }});
    return generator;
}

/// Two lines, parallel or nearly so too.
std::shared_ptr<const Generator> lines_generator() {
    auto generator =
        std::make_shared<Generator>(*hybrid::triangles("conservative/lines", {.points = {6, 8}}));
    generator->loci.push_back(
        {"parallel lines", "slivers", [](Random& random, double distance, std::span<double> n) {
             const double x = n[2] - n[0], y = n[3] - n[1], t = 2 * random.unit() - 1;
             const double side = random.chance(0.5) ? distance : -distance;
             n[6] = std::clamp(n[4] + t * x - side * y, -hybrid::farthest, hybrid::farthest);
             n[7] = std::clamp(n[5] + t * y + side * x, -hybrid::farthest, hybrid::farthest);
         }});
    return generator;
}

/// Unit normals all round, and texels of every size.
std::shared_ptr<const Generator> texel_generator() {
    auto generator = std::make_shared<Generator>();
    generator->name = "conservative/texels";
    generator->draw = [](Random& random, std::span<double> n) {
        const double angle = 6.283185307179586 * random.unit();
        n[0] = std::cos(angle), n[1] = std::sin(angle);
        n[2] = std::exp2(1 - 20 * random.unit()), n[3] = std::exp2(1 - 20 * random.unit());
    };
    return generator;
}

/// Points and boxes on a coarse grid: on borders and corners as often as beside them.
std::shared_ptr<const Generator> grid_generator() {
    auto generator = std::make_shared<Generator>();
    generator->name = "conservative/grid";
    generator->draw = [](Random& random, std::span<double> numbers) {
        for (double& number : numbers) number = random.between(-8, 8) / 4.0;
    };
    return generator;
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
                .tolerance = conditioned(8),
                .where = [](const Arguments& a) { return truth::is_clear(truth::sine_between(a)); },
                .generator = lines_generator(),
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
                .outside = left_of_the_edge,
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
                .outside = around_a_line,
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
                .outside = clip_box_beyond,
            },
            {
                .name = "conservative/in_clip_box",
                .source = "Hybrid hard shadows, figure 8; Hasselgren et al. 2005",
                .reference = in_clip_box,
                .parameters = {{"p", {-2, 2, {}}, "map", "a point"},
                               {"box", {-2, 2, {}}, "map", "smallest x and y, largest x and y"}},
                .result = {0, 1, "1", "whether the point is in the box"},
                .generator = grid_generator(),
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
                .outside = first_corner,
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
                .outside = no_if_not_finite,
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
                .outside = no_if_not_finite,
            },
            {
                .name = "conservative/tight_offset",
                .source = "Hasselgren et al. 2005",
                .reference = reference_by<double(dvec2, dvec2)>(truth::tight_offset),
                .parameters = {{"normal", {-1, 1, {}}, "1", "the edge's unit normal"},
                               {"texel", {0, 2, {}}, "map", "the texel's width and height"}},
                .result = {0, FLT_MAX, "map", "how far the edge must move"},
                .tolerance = conditioned(2),
                .generator = texel_generator(),
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
                .generator = depths_generator("conservative/depth_at", false),
                .rule = "edge-on: the nearest corner's depth",
                .within = near_the_plane,
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
                .generator = depths_generator("conservative/depth_bounds", true),
                .rule = "edge-on, or over a texel that is not finite: the nearest and the farthest corner's "
                        "depth",
                .outside = anywhere_between,
                .within = around_the_plane,
            },
        }};
}

} // namespace gnomon
