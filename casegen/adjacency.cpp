// The table of kernels/adjacency: what is left of a triangle between lit and shadowed neighbours.
#include "casegen/catalogue.h"
#include "casegen/hybrid/triangles.h"
#include "casegen/reference/hybrid/remains.h"
#include "casegen/reference/hybrid/truth.h"

#include <cfloat>

namespace gnomon {
namespace {

namespace truth = reference::hybrid;
using glm::dvec2;

Parameter point(const char* name, const char* meaning) {
    return {name, {-hybrid::farthest, hybrid::farthest, {}}, "map", meaning};
}
Parameter emitted(double last) { return {"corner", {0, last, {}}, "1", "the number of the emitted vertex"}; }
Parameter away(std::vector<std::vector<double>> choices) {
    return {"away",
            {0, 7, std::move(choices)},
            "bits",
            "neighbours that face away from the light: 1 across v0 v2, 2 across v2 v4, 4 across v4 v0"};
}
std::vector<Parameter> parameters(std::vector<Parameter> more) {
    std::vector<Parameter> all{point("v0", "the triangle's corners, in the light's view"),
                               point("v2", "the second"),
                               point("v4", "the third"),
                               {"lambda", {0, hybrid::farthest, {}}, "map", "how far lit edges move in"}};
    for (Parameter& each : more) all.push_back(std::move(each));
    return all;
}

unsigned word(const Arguments& arguments, std::size_t i) {
    return static_cast<unsigned>(arguments.numbers[i]);
}

/// A kernel's `away`, which corners it cuts, and the emitted vertex.
struct Asked {
    unsigned away, cut, corner;
};
using Ask = Asked (*)(const Arguments&);
Asked none(const Arguments& a) { return {0, 0, word(a, 7)}; }
Asked all(const Arguments& a) { return {7, 7, word(a, 7)}; }
Asked some(const Arguments& a) { return {word(a, 7), truth::between(word(a, 7)), word(a, 8)}; }
Asked ring(const Arguments& a) { return {word(a, 7), truth::between(word(a, 7)) & ~word(a, 8), word(a, 9)}; }
template <Ask ask>
Truth shrunken(const Arguments& arguments) {
    const Asked asked = ask(arguments);
    return truth::shrunken(arguments, asked.away, asked.cut, asked.corner);
}
template <Ask ask>
bool is_clear(const Arguments& arguments) {
    const Asked asked = ask(arguments);
    return truth::remains(truth::triangle_of(arguments), arguments.numbers[6], asked.away, asked.cut)
        .is_clear;
}

/// By exact signs: which of three triangles around one are wound as it is.
unsigned wound_alike(dvec2 v0, dvec2 v1, dvec2 v2, dvec2 v3, dvec2 v4, dvec2 v5) {
    const auto winding = [](dvec2 a, dvec2 b, dvec2 c) {
        const truth::Triangle<double> t{truth::Point<double>{a.x, a.y}, {b.x, b.y}, {c.x, c.y}};
        if (truth::least_sine(t) < truth::parallel) return 0;
        return truth::area2(t[0], t[1], t[2]) < 0 ? -1 : 1;
    };
    const int product[] = {winding(v0, v1, v2) * winding(v0, v2, v4),
                           winding(v2, v3, v4) * winding(v0, v2, v4),
                           winding(v4, v5, v0) * winding(v0, v2, v4)};
    return (product[0] > 0 ? 1u : 0u) + (product[1] > 0 ? 2u : 0u) + (product[2] > 0 ? 4u : 0u);
}
/// No rounding decides whether one of the four is seen edge-on.
bool windings_are_clear(const Arguments& arguments) {
    const auto v = [&](std::size_t i) {
        return truth::Point<double>{arguments.numbers[2 * i], arguments.numbers[2 * i + 1]};
    };
    for (const auto& t : {truth::Triangle<double>{v(0), v(2), v(4)},
                          {v(0), v(1), v(2)},
                          {v(2), v(3), v(4)},
                          {v(4), v(5), v(0)}})
        if (!truth::is_clear(truth::least_sine(t))) return false;
    return true;
}

using Whole = dvec2(dvec2, dvec2, dvec2, double, unsigned);
using Between = dvec2(dvec2, dvec2, dvec2, double, unsigned, unsigned);
using Ring = dvec2(dvec2, dvec2, dvec2, double, unsigned, unsigned, unsigned);

} // namespace

Family adjacency_family() {
    const Result vertex{-FLT_MAX, FLT_MAX, "map", "a vertex of an emitted triangle"};
    const char* const rule =
        "nothing left, a line, or an input that is not finite: all vertices in one place";
    // The polygon's corners are rounded as weights, and as points.
    const Tolerance tolerance = conditioned(8);
    return {
        "adjacency",
        "CRSMA's shrunken triangles: edges to shadowed neighbours stay, lit ones move in, corners are cut",
        {
            {
                .name = "adjacency/away",
                .source = "Hybrid hard shadows, figure 26 and equation 20",
                .reference = wound_alike,
                .parameters = {point("v0", "the triangle's corners are v0, v2, v4"),
                               point("v1", "the neighbour's across v0 v2"), point("v2", "the second corner"),
                               point("v3", "the neighbour's across v2 v4"), point("v4", "the third corner"),
                               point("v5", "the neighbour's across v4 v0")},
                .result = {0, 7, "bits", "neighbours that face as the triangle does"},
                .where = windings_are_clear,
                .generator = hybrid::triangles("adjacency/away", {.stride = 4, .points = {2, 6, 10}}),
                .rule = "a missing neighbour and one seen edge-on count as lit, 0",
            },
            {
                .name = "adjacency/shadowed_0",
                .source = "Hybrid hard shadows, 4.1",
                .reference = reference_by<Whole>(shrunken<none>),
                .parameters = parameters({emitted(2)}),
                .result = vertex,
                .tolerance = tolerance,
                .where = is_clear<none>,
                .generator =
                    hybrid::shrunken_triangles("adjacency/shadowed_0", {.distance = 6, .counts = {{7, 2}}}),
                .rule = rule,
            },
            {
                .name = "adjacency/shadowed_1",
                .source = "Hybrid hard shadows, 4.2, equation 21",
                .reference = reference_by<Between>(shrunken<some>),
                .parameters = parameters({away({{1}, {2}, {4}}), emitted(2)}),
                .result = vertex,
                .tolerance = tolerance,
                .where = is_clear<some>,
                .generator = hybrid::shrunken_triangles(
                    "adjacency/shadowed_1",
                    {.distance = 6, .counts = {{7, 7}, {8, 2}}, .choices_away = {1, 2, 4}}),
                .rule = rule,
            },
            {
                .name = "adjacency/shadowed_2",
                .source = "Hybrid hard shadows, 4.3, equation 22",
                .reference = reference_by<Between>(shrunken<some>),
                .parameters = parameters({away({{3}, {5}, {6}}), emitted(5)}),
                .result = vertex,
                .tolerance = tolerance,
                .where = is_clear<some>,
                .generator = hybrid::shrunken_triangles(
                    "adjacency/shadowed_2",
                    {.distance = 6, .counts = {{7, 7}, {8, 5}}, .choices_away = {3, 5, 6}}),
                .rule = rule,
            },
            {
                .name = "adjacency/shadowed_3",
                .source = "Hybrid hard shadows, 4.4, equation 23",
                .reference = reference_by<Whole>(shrunken<all>),
                .parameters = parameters({emitted(11)}),
                .result = vertex,
                .tolerance = tolerance,
                .where = is_clear<all>,
                .generator =
                    hybrid::shrunken_triangles("adjacency/shadowed_3", {.distance = 6, .counts = {{7, 11}}}),
                .rule = rule,
            },
            {
                .name = "adjacency/shrunken",
                .source = "Hybrid hard shadows, chapter 4",
                .reference = reference_by<Between>(shrunken<some>),
                .parameters = parameters({away({}), emitted(11)}),
                .result = vertex,
                .tolerance = tolerance,
                .where = is_clear<some>,
                .generator = hybrid::shrunken_triangles("adjacency/shrunken",
                                                        {.distance = 6, .counts = {{7, 7}, {8, 11}}}),
                .rule = rule,
            },
            {
                .name = "adjacency/one_ring",
                .source = "Hybrid hard shadows, 4.5: the cure that it names",
                .reference = reference_by<Ring>(shrunken<ring>),
                .parameters = parameters(
                    {away({}),
                     {"inner", {0, 7, {}}, "bits", "vertices whose faces all face away: 1 v0, 2 v2, 4 v4"},
                     emitted(11)}),
                .result = vertex,
                .tolerance = tolerance,
                .where = is_clear<ring>,
                .generator = hybrid::shrunken_triangles("adjacency/one_ring",
                                                        {.distance = 6, .counts = {{7, 7}, {8, 7}, {9, 11}}}),
                .rule = rule,
            },
        }};
}

} // namespace gnomon
