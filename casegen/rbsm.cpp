// The tables of kernels/rbsm: four shapes for SMSR's twelve cases, five for RSMSS's 31.
#include "casegen/reference/rbsm.h"
#include "casegen/catalogue.h"
#include "casegen/vocabulary.h"

#include <algorithm>

namespace gnomon {

using namespace vocabulary;
using glm::dvec2;

namespace {

using reference::Edge;

const Family& silhouette();
const Family& filter();

/// The conditions with a side somewhere, and these types.
Conditions edge_with(unsigned light, unsigned type_x, unsigned type_y) {
    return {{light, sets::any_side, sets::some, type_x, type_y},
            {light, sets::some, sets::neither, type_x, type_y}};
}
Conditions either(Conditions a, const Conditions& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
constexpr unsigned not_closed = sets::open | sets::one_end, any_light = sets::lit | sets::shadowed;

// The shapes by the ends of the runs along both axes, whether or not there is a side along each.
Conditions shape_i(unsigned light) {
    return either(edge_with(light, sets::open, not_closed), edge_with(light, sets::one_end, sets::open));
}
Conditions shape_u(unsigned light) {
    return either(edge_with(light, sets::closed, not_closed), edge_with(light, not_closed, sets::closed));
}
Conditions shape_l(unsigned light) { return edge_with(light, sets::one_end, sets::one_end); }
Conditions shape_o(unsigned light) { return edge_with(light, sets::closed, sets::closed); }

/// Across a BOTH the walks end at once.
bool both_is_closed(const Arguments& a) {
    constexpr double on_both = both;
    return (a.numbers[0] != on_both || a.numbers[2] == 1) && (a.numbers[1] != on_both || a.numbers[3] == 1);
}

const Result visibility{0, 1, "1", "1 lit, 0 shadowed"};

const Family& silhouette() {
    static const Family family{
        "rbsm/silhouette",
        "silhouette revectorisation by four shapes of an edge, and the assembled visibility",
        {
            {
                .name = "rbsm/silhouette/i",
                .source = "Optimized RBSM 2017, listing 4, I-shape",
                .reference = [](dvec2) { return 1.0; },
                .parameters = {p()},
                .result = visibility,
                .condition = shape_i(sets::lit),
                .number = 1,
                .formula = "1",
            },
            {
                .name = "rbsm/silhouette/u",
                .source = "Optimized RBSM 2017, listing 4, short and long U-shape",
                .reference = [](dvec2) { return 0.0; },
                .parameters = {p()},
                .result = visibility,
                .condition = shape_u(sets::lit),
                .number = 2,
                .formula = "0",
            },
            {
                .name = "rbsm/silhouette/l",
                .source = "Optimized RBSM 2017, listing 4, L-shape",
                .reference = [](double along_x, double along_y) { return along_x + along_y > 1 ? 0.0 : 1.0; },
                .parameters = {along_x(), along_y()},
                .result = visibility,
                .tolerance = input_within(0x1p-24), // half an ulp below 1, of 1 - along_y
                .exact_where = on_grid,
                .condition = shape_l(sets::lit),
                .number = 3,
                .formula = "0 if 1 - along_y < along_x; 1 otherwise",
            },
            {
                .name = "rbsm/silhouette/o",
                .source = "Optimized RBSM 2017, listing 4, short and long O-shape",
                .reference = [](dvec2) { return 0.0; },
                .parameters = {p()},
                .result = visibility,
                .condition = shape_o(sets::lit),
                .number = 4,
                .formula = "0",
            },
            {
                .name = "rbsm/silhouette/decision",
                .source = "Optimized RBSM 2017, listing 4 and figure 2",
                .reference =
                    [](glm::uvec2 sides, glm::ivec2 type) {
                        return number_by_conditions(silhouette(), {sides, {}, type});
                    },
                .parameters = {sides(), type()},
                .result = {0, 4, "1", "1 I, 2 U, 3 L, 4 O, 0 none"},
                .where = both_is_closed,
            },
            {
                .name = "rbsm/silhouette/number",
                .source = "Optimized RBSM 2017, figure 2",
                .reference =
                    [](const Mask& mask, glm::ivec2 texel) {
                        return number_by_conditions(silhouette(), reference::edge(mask, texel));
                    },
                .parameters = {texel()},
                .result = {0, 4, "1", "1 I, 2 U, 3 L, 4 O, 0 none"},
            },
            {
                .name = "rbsm/silhouette/visibility",
                .source = "Optimized RBSM 2017, listing 4",
                .reference =
                    [](const Mask& mask, glm::ivec2 texel, dvec2 p) {
                        const Edge edge = reference::edge(mask, texel);
                        if (!edge.lit || edge.sides == glm::uvec2(0)) return edge.lit ? 1.0 : 0.0;
                        return reference::rbsm_silhouette(edge, p);
                    },
                .parameters = {texel(), p()},
                .result = visibility,
                // Two positions along runs (revectorize/along: 2^-22 each): along a run of 16 texels that is
                // 2^-18.
                .tolerance = input_within(0x1p-17),
            },
        }};
    return family;
}

const Family& filter() {
    static const Family family{
        "rbsm/filter",
        "filtering revectorisation by five shapes of an edge, and the assembled visibility",
        {
            {
                .name = "rbsm/filter/i",
                .source = "Optimized RBSM 2017, listing 5, I-shape (its test corrected to -1)",
                .reference = [](bool entering) { return entering ? 1.0 : 0.0; },
                .parameters = {entering()},
                .result = visibility,
                .condition = shape_i(any_light),
                .number = 1,
                .formula = "1 - d_c.b",
            },
            {
                .name = "rbsm/filter/u",
                .source = "Optimized RBSM 2017, listing 5, U-shape",
                .reference =
                    [](double along_x, double along_y, glm::ivec2 type, bool entering) {
                        const double distance = 1 - (type.x == 1 ? along_y : along_x);
                        return entering ? distance : 1 - distance;
                    },
                .parameters = {along_x(), along_y(), type(), entering()},
                .result = visibility,
                .tolerance = absolute(0x1p-24), // 1 - along
                .exact_where = on_grid,
                .condition = shape_u(any_light),
                .number = 2,
                .formula = "1 - along_y if t_h = 1 and entering; along_y if t_h = 1; 1 - along_x if "
                           "entering; along_x otherwise",
            },
            {
                .name = "rbsm/filter/l",
                .source = "Optimized RBSM 2017, listing 5, L-shape",
                .reference =
                    [](double along_x, double along_y, bool entering) {
                        const double distance = std::min(2 - along_x - along_y, 1.0);
                        return entering ? distance : 1 - distance;
                    },
                .parameters = {along_x(), along_y(), entering()},
                .result = visibility,
                .tolerance = absolute(0x1p-22), // two halves of an ulp below 1, one of 2, one below 1
                .exact_where = on_grid,
                .condition = shape_l(any_light),
                .number = 3,
                .formula = "2 - along_x - along_y if entering; along_x + along_y - 1 otherwise",
            },
            {
                .name = "rbsm/filter/short_o",
                .source = "Optimized RBSM 2017, listing 5, short O-shape",
                .reference = [](bool entering) { return entering ? 0.0 : 1.0; },
                .parameters = {entering()},
                .result = visibility,
                .condition = {{any_light, sets::both, sets::both}},
                .number = 4,
                .formula = "d_c.b",
            },
            {
                .name = "rbsm/filter/long_o",
                .source = "Optimized RBSM 2017, listing 5, long O-shape",
                .reference = [](bool entering) { return entering ? 0.0 : 1.0; },
                .parameters = {entering()},
                .result = visibility,
                .condition = {{any_light, sets::some, sets::neither | sets::one, sets::closed, sets::closed},
                              {any_light, sets::neither | sets::one, sets::some, sets::closed, sets::closed}},
                .number = 5,
                .formula = "d_c.b",
            },
            {
                .name = "rbsm/filter/decision",
                .source = "Optimized RBSM 2017, listing 5 and figure 2",
                .reference =
                    [](glm::uvec2 sides, glm::ivec2 type) {
                        return number_by_conditions(filter(), {sides, {}, type});
                    },
                .parameters = {sides(), type()},
                .result = {0, 5, "1", "1 I, 2 U, 3 L, 4 short O, 5 long O, 0 none"},
                .where = both_is_closed,
            },
            {
                .name = "rbsm/filter/number",
                .source = "Optimized RBSM 2017, figure 2",
                .reference =
                    [](const Mask& mask, glm::ivec2 texel) {
                        return number_by_conditions(filter(), reference::edge(mask, texel));
                    },
                .parameters = {texel()},
                .result = {0, 5, "1", "1 I, 2 U, 3 L, 4 short O, 5 long O, 0 none"},
            },
            {
                .name = "rbsm/filter/visibility",
                .source = "Optimized RBSM 2017, listing 5",
                .reference =
                    [](const Mask& mask, glm::ivec2 texel, dvec2 p) {
                        const Edge edge = reference::edge(mask, texel);
                        if (edge.sides == glm::uvec2(0)) return edge.lit ? 1.0 : 0.0;
                        return reference::rbsm_filter(edge, p);
                    },
                .parameters = {texel(), p()},
                .result = visibility,
                .tolerance = absolute(0x1p-21 + 0x1p-22), // two positions of 2^-22 each, and filter/l's own
            },
        }};
    return family;
}

} // namespace

Family rbsm_silhouette_family() { return silhouette(); }
Family rbsm_filter_family() { return filter(); }

} // namespace gnomon
