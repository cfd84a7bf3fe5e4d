// The table of kernels/rsmss: the 31 cases, the decision list over them, and their assembly.
//
// References are written by distances from walls and ends and by symmetry, where the kernels list the
// document's rows side by side. Each case's condition is written for itself (docs/revectorization.md 4.2):
// that at most one holds for every edge a texel can have is what the decision list is tested against.
#include "casegen/reference/rsmss.h"
#include "casegen/catalogue.h"
#include "casegen/vocabulary.h"

#include <algorithm>

namespace gnomon {

using namespace vocabulary;
using glm::dvec2;
using glm::uvec2;

namespace {

double unit(double v) { return std::clamp(v, 0.0, 1.0); }

// Distances of the point from a side of its texel.
double from_x(dvec2 p, unsigned side) { return side == minus ? p.x : 1 - p.x; }
double from_y(dvec2 p, unsigned side) { return side == minus ? p.y : 1 - p.y; }
dvec2 turned(dvec2 p) { return {p.y, p.x}; }

/// Light beside a wall at distance q, where the run has one end or two. Exiting edges are what it leaves.
double ramp(double q, double along, int type) { return unit(type == 1 ? q : 1 + q - along); }

bool one_wall(unsigned walls) { return walls == minus || walls == plus; }

/// Case 4: a slot along y between two ends.
double between_ends(dvec2 p, uvec2 neighbours, unsigned options) {
    const double above = unit(from_x(p, neighbours.y) + from_y(p, minus) - 1);
    const double below = unit(from_x(p, neighbours.x) + from_y(p, plus) - 1);
    if (!one_wall(neighbours.y)) return one_wall(neighbours.x) ? below : 0;
    if (!one_wall(neighbours.x) || (options & reference::first_opening) != 0) return above;
    return std::max(above, below);
}

/// Case 5: the end of a slot along y, with an end further on too.
double end_between_ends(dvec2 p, double along_y, unsigned side_y, unsigned neighbour, unsigned options) {
    if (one_wall(neighbour)) return unit(from_x(p, neighbour) + from_y(p, side_y) - 1);
    if (neighbour == neither || (options & reference::printed_end) == 0) return 0;
    const double nearer_wall = std::min(p.x, 1 - p.x);
    return unit(std::min(nearer_wall + 1 - along_y, from_y(p, side_y)));
}

/// Of the light by the walls at minus and plus, which one counts.
double by_breach(unsigned breach, double by_minus, double by_plus, unsigned options) {
    if (breach == minus) return by_minus;
    if (breach == plus || (options & (reference::first_breach | reference::opposite_breach)) == 0)
        return breach == plus ? by_plus : std::max(by_minus, by_plus);
    return (options & reference::first_breach) != 0 ? by_minus : std::min(by_minus, by_plus);
}

/// Cases 8 and 9: a slot along y with light at one end.
double end_of_passage(dvec2 p, double along_y, unsigned side_y, unsigned breach) {
    if (!one_wall(breach)) return unit(1 - along_y);
    return unit(std::min(from_y(p, side_y), from_x(p, breach) + 1 - along_y));
}
double passage(dvec2 p, double along_y, unsigned breach, unsigned options) {
    if (breach == neither || breach == reference::unbroken) return unit(1 - along_y);
    return unit(by_breach(breach, p.x + 1 - along_y, 2 - p.x - along_y, options));
}

/// Cases 12 and 13: a bar along y. What a slot would lose, except that ends with a far breach and bars
/// without any are read otherwise.
double end_of_bar(dvec2 p, double along_y, unsigned side_y, int type_y, unsigned neighbour, unsigned breach,
                  unsigned options) {
    const bool far = neighbour == both;
    const unsigned walls = far ? breach : neighbour;
    const double from_end = from_y(p, side_y);
    if (walls == reference::unbroken && type_y == 1)
        return (options & reference::ramped_bar) != 0 ? unit(std::max({1 - from_end, p.x, 1 - p.x})) : 0;
    if (!one_wall(walls)) return unit(along_y);
    const bool whole_width = type_y == 1 || (far && (options & reference::breach_by_position) == 0);
    const double taken = from_x(p, walls) + (whole_width ? 0 : 1 - along_y);
    return 1 - unit(std::min(from_end, taken));
}
double bar(dvec2 p, double along_y, int type_y, unsigned breach, unsigned options) {
    if (breach == reference::unbroken && type_y == 1)
        return (options & reference::ramped_bar) != 0 ? unit(std::max(p.x, 1 - p.x)) : 0;
    if (breach == neither || breach == reference::unbroken) return unit(along_y);
    const double beyond = type_y == 1 ? 0 : 1 - along_y;
    return 1 - unit(by_breach(breach, p.x + beyond, 1 - p.x + beyond, options));
}

// Conditions that several cases share.
constexpr unsigned one_or_neither = sets::one | sets::neither;
Conditions slot_y(unsigned light, unsigned side_y, unsigned type_y) {
    return {{.light = light, .side_x = sets::both, .side_y = side_y, .type_y = type_y}};
}
Conditions slot_x(unsigned light, unsigned side_x, unsigned type_x) {
    return {{.light = light, .side_x = side_x, .side_y = sets::both, .type_x = type_x}};
}
Conditions any_corner(unsigned light, unsigned dominant) {
    return {corner(light, sets::one, sets::one, sets::any_type, sets::any_type, dominant)};
}

/// Three roundings of numbers below 2, of half an ulp (2^-24) each.
const Tolerance three_roundings = absolute(0x1.8p-23);

/// The position along a run (revectorize/along: 2^-22) and the roundings of a case.
const Tolerance through_a_run = absolute(0x1p-22 + 0x1.8p-23);

const Family& table();

const Family& table() {
    using namespace sets;
    const Result visibility{0, 1, "1", "1 lit, 0 shadowed"};
    static const Family family{
        "rsmss",
        "filtering revectorisation: 31 cases, the decision list, and the assembled visibility",
        {
            {
                .name = "rsmss/case_01",
                .source = "RBSM supplement, RSMSS case 1",
                .reference = [](dvec2) { return 1.0; },
                .parameters = {p()},
                .result = visibility,
                .condition = {run_along_x(lit, one, open), run_along_y(lit, one, open),
                              slot_y(lit, one_or_neither, open).front(),
                              slot_x(lit, one_or_neither, open).front()},
                .number = 1,
                .formula = "1",
            },
            {
                .name = "rsmss/case_02",
                .source = "RBSM supplement, RSMSS case 2",
                .reference = [](dvec2) { return 0.0; },
                .parameters = {p()},
                .result = visibility,
                .condition = {{.light = lit, .side_x = sets::both, .side_y = sets::both}},
                .number = 2,
                .formula = "0",
            },
            {
                .name = "rsmss/case_03",
                .source = "RBSM supplement, RSMSS case 3",
                .reference = [](dvec2) { return 1.0; },
                .parameters = {p()},
                .result = visibility,
                .condition = {{.light = shadowed, .side_x = sets::both, .side_y = sets::both}},
                .number = 3,
                .formula = "1",
            },
            {
                .name = "rsmss/case_04",
                .source = "RBSM supplement, RSMSS case 4",
                .reference = between_ends,
                .parameters = {p(), neighbours(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_y(lit, sets::neither, closed),
                .number = 4,
                .formula = "0 if n_-y = BOTH and n_+y = BOTH; "
                           "w_+y + p.y - 1 if n_-y = BOTH; "
                           "w_-y - p.y if n_+y = BOTH; "
                           "max(w_+y + p.y - 1, w_-y - p.y) otherwise",
            },
            {
                .name = "rsmss/case_05",
                .source = "RBSM supplement, RSMSS case 5",
                .reference = end_between_ends,
                .parameters = {p(), along_y(), side_y(), neighbour(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_y(lit, one, closed),
                .number = 5,
                .formula = "0 if n = BOTH; "
                           "q_y + w - 1 otherwise",
            },
            {
                .name = "rsmss/case_06",
                .source = "RBSM supplement, RSMSS case 6",
                .reference = [](dvec2 p, uvec2 neighbours,
                                unsigned options) { return between_ends(turned(p), neighbours, options); },
                .parameters = {p(), neighbours(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_x(lit, sets::neither, closed),
                .number = 6,
                .formula = "0 if n_-x = BOTH and n_+x = BOTH; "
                           "w_+x + p.x - 1 if n_-x = BOTH; "
                           "w_-x - p.x if n_+x = BOTH; "
                           "max(w_+x + p.x - 1, w_-x - p.x) otherwise",
            },
            {
                .name = "rsmss/case_07",
                .source = "RBSM supplement, RSMSS case 7",
                .reference =
                    [](dvec2 p, double along_x, unsigned side_x, unsigned neighbour, unsigned options) {
                        return end_between_ends(turned(p), along_x, side_x, neighbour, options);
                    },
                .parameters = {p(), along_x(), side_x(), neighbour(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_x(lit, one, closed),
                .number = 7,
                .formula = "0 if n = BOTH; "
                           "q_x + w - 1 otherwise",
            },
            {
                .name = "rsmss/case_08",
                .source = "RBSM supplement, RSMSS case 8",
                .reference = end_of_passage,
                .parameters = {p(), along_y(), side_y(), breach()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_y(lit, one, one_end),
                .number = 8,
                .formula = "1 - along_y if d_cb = NEITHER or d_cb = UNBROKEN; "
                           "min(q_y, 1 + w_cb - along_y) otherwise",
            },
            {
                .name = "rsmss/case_09",
                .source = "RBSM supplement, RSMSS case 9",
                .reference = passage,
                .parameters = {p(), along_y(), breach(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_y(lit, sets::neither, one_end),
                .number = 9,
                .formula = "1 - along_y if d_cb = NEITHER or d_cb = UNBROKEN; "
                           "max(1 + p.x - along_y, 2 - p.x - along_y) if d_cb = BOTH; "
                           "1 + w_cb - along_y otherwise",
            },
            {
                .name = "rsmss/case_10",
                .source = "RBSM supplement, RSMSS case 10",
                .reference =
                    [](dvec2 p, double along_x, unsigned side_x, unsigned breach) {
                        return end_of_passage(turned(p), along_x, side_x, breach);
                    },
                .parameters = {p(), along_x(), side_x(), breach()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_x(lit, one, one_end),
                .number = 10,
                .formula = "1 - along_x if d_cb = NEITHER or d_cb = UNBROKEN; "
                           "min(q_x, 1 + w_cb - along_x) otherwise",
            },
            {
                .name = "rsmss/case_11",
                .source = "RBSM supplement, RSMSS case 11",
                .reference = [](dvec2 p, double along_x, unsigned breach,
                                unsigned options) { return passage(turned(p), along_x, breach, options); },
                .parameters = {p(), along_x(), breach(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_x(lit, sets::neither, one_end),
                .number = 11,
                .formula = "1 - along_x if d_cb = NEITHER or d_cb = UNBROKEN; "
                           "max(1 + p.y - along_x, 2 - p.y - along_x) if d_cb = BOTH; "
                           "1 + w_cb - along_x otherwise",
            },
            {
                .name = "rsmss/case_12",
                .source = "RBSM supplement, RSMSS case 12",
                .reference = end_of_bar,
                .parameters = {p(), along_y(), side_y(), type_y(), neighbour(), breach(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_y(shadowed, one, one_end | closed),
                .number = 12,
                .formula = "along_y if n = NEITHER; "
                           "0 if n = BOTH and d_cb = UNBROKEN and t_v = 1; "
                           "along_y if n = BOTH and d_cb = UNBROKEN; "
                           "along_y if n = BOTH and d_cb = NEITHER; "
                           "max(1 - q_y, 1 - w_cb) if n = BOTH; "
                           "max(1 - q_y, 1 - w) if t_v = 1; "
                           "max(1 - q_y, along_y - w) otherwise",
            },
            {
                .name = "rsmss/case_13",
                .source = "RBSM supplement, RSMSS case 13",
                .reference = bar,
                .parameters = {p(), along_y(), type_y(), breach(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_y(shadowed, sets::neither, one_end | closed),
                .number = 13,
                .formula = "0 if d_cb = UNBROKEN and t_v = 1; "
                           "along_y if d_cb = UNBROKEN or d_cb = NEITHER; "
                           "min(1 - p.x, p.x) if d_cb = BOTH and t_v = 1; "
                           "min(along_y - p.x, along_y + p.x - 1) if d_cb = BOTH; "
                           "1 - w_cb if t_v = 1; "
                           "along_y - w_cb otherwise",
            },
            {
                .name = "rsmss/case_14",
                .source = "RBSM supplement, RSMSS case 14",
                .reference =
                    [](dvec2 p, double along_x, unsigned side_x, int type_x, unsigned neighbour,
                       unsigned breach, unsigned options) {
                        return end_of_bar(turned(p), along_x, side_x, type_x, neighbour, breach, options);
                    },
                .parameters = {p(), along_x(), side_x(), type_x(), neighbour(), breach(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_x(shadowed, one, one_end | closed),
                .number = 14,
                .formula = "along_x if n = NEITHER; "
                           "0 if n = BOTH and d_cb = UNBROKEN and t_h = 1; "
                           "along_x if n = BOTH and d_cb = UNBROKEN; "
                           "along_x if n = BOTH and d_cb = NEITHER; "
                           "max(1 - q_x, 1 - w_cb) if n = BOTH; "
                           "max(1 - q_x, 1 - w) if t_h = 1; "
                           "max(1 - q_x, along_x - w) otherwise",
            },
            {
                .name = "rsmss/case_15",
                .source = "RBSM supplement, RSMSS case 15",
                .reference =
                    [](dvec2 p, double along_x, int type_x, unsigned breach, unsigned options) {
                        return bar(turned(p), along_x, type_x, breach, options);
                    },
                .parameters = {p(), along_x(), type_x(), breach(), options()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = slot_x(shadowed, sets::neither, one_end | closed),
                .number = 15,
                .formula = "0 if d_cb = UNBROKEN and t_h = 1; "
                           "along_x if d_cb = UNBROKEN or d_cb = NEITHER; "
                           "min(1 - p.y, p.y) if d_cb = BOTH and t_h = 1; "
                           "min(along_x - p.y, along_x + p.y - 1) if d_cb = BOTH; "
                           "1 - w_cb if t_h = 1; "
                           "along_x - w_cb otherwise",
            },
            {
                .name = "rsmss/case_16",
                .source = "RBSM supplement, RSMSS case 16",
                .reference = [](dvec2 p, double along_y, unsigned side_x,
                                int type_y) { return ramp(from_x(p, side_x), along_y, type_y); },
                .parameters = {p(), along_y(), side_x(), type_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(lit, goes_on_x),
                .number = 16,
                .formula = "q_x if t_v = 1; 1 + q_x - along_y otherwise",
            },
            {
                .name = "rsmss/case_17",
                .source = "RBSM supplement, RSMSS case 17",
                .reference = [](dvec2 p, double along_x, unsigned side_y,
                                int type_x) { return ramp(from_y(p, side_y), along_x, type_x); },
                .parameters = {p(), along_x(), side_y(), type_x()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(lit, goes_on_y),
                .number = 17,
                .formula = "q_y if t_h = 1; 1 + q_y - along_x otherwise",
            },
            {
                .name = "rsmss/case_18",
                .source = "RBSM supplement, RSMSS case 18",
                .reference = [](dvec2 p, double along_x,
                                unsigned side_y) { return ramp(from_y(p, side_y), along_x, 0); },
                .parameters = {p(), along_x(), side_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(lit, ends_both),
                .number = 18,
                .formula = "1 + q_y - along_x",
            },
            {
                .name = "rsmss/case_19",
                .source = "RBSM supplement, RSMSS case 19",
                .reference =
                    [](dvec2 p, double along_x, double along_y, unsigned side_x, unsigned side_y, int type_x,
                       int type_y) {
                        return std::min(ramp(from_x(p, side_x), along_y, type_y),
                                        ramp(from_y(p, side_y), along_x, type_x));
                    },
                .parameters = {p(), along_x(), along_y(), side_x(), side_y(), type_x(), type_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(lit, goes_on_both),
                .number = 19,
                .formula = "min(E_x, E_y)",
            },
            {
                .name = "rsmss/case_20",
                .source = "RBSM supplement, RSMSS case 20",
                .reference = [](dvec2 p, unsigned side_y) { return ramp(from_y(p, side_y), 0, 1); },
                .parameters = {p(), side_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_x(lit, one, closed)},
                .number = 20,
                .formula = "q_y",
            },
            {
                .name = "rsmss/case_21",
                .source = "RBSM supplement, RSMSS case 21",
                .reference = [](dvec2 p, unsigned side_x) { return ramp(from_x(p, side_x), 0, 1); },
                .parameters = {p(), side_x()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_y(lit, one, closed)},
                .number = 21,
                .formula = "q_x",
            },
            {
                .name = "rsmss/case_22",
                .source = "RBSM supplement, RSMSS case 22",
                .reference = [](dvec2 p, double along_x,
                                unsigned side_y) { return ramp(from_y(p, side_y), along_x, 0); },
                .parameters = {p(), along_x(), side_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_x(lit, one, one_end)},
                .number = 22,
                .formula = "1 + q_y - along_x",
            },
            {
                .name = "rsmss/case_23",
                .source = "RBSM supplement, RSMSS case 23",
                .reference = [](dvec2 p, double along_y,
                                unsigned side_x) { return ramp(from_x(p, side_x), along_y, 0); },
                .parameters = {p(), along_y(), side_x()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_y(lit, one, one_end)},
                .number = 23,
                .formula = "1 + q_x - along_y",
            },
            {
                .name = "rsmss/case_24",
                .source = "RBSM supplement, RSMSS case 24",
                .reference = [](dvec2 p, double along_y, unsigned side_x,
                                int type_y) { return 1 - ramp(from_x(p, side_x), along_y, type_y); },
                .parameters = {p(), along_y(), side_x(), type_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(shadowed, goes_on_x),
                .number = 24,
                .formula = "1 - q_x if t_v = 1; along_y - q_x otherwise",
            },
            {
                .name = "rsmss/case_25",
                .source = "RBSM supplement, RSMSS case 25",
                .reference = [](dvec2 p, double along_x, unsigned side_y,
                                int type_x) { return 1 - ramp(from_y(p, side_y), along_x, type_x); },
                .parameters = {p(), along_x(), side_y(), type_x()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(shadowed, goes_on_y),
                .number = 25,
                .formula = "1 - q_y if t_h = 1; along_x - q_y otherwise",
            },
            {
                .name = "rsmss/case_26",
                .source = "RBSM supplement, RSMSS case 26",
                .reference = [](dvec2 p, double along_x,
                                unsigned side_y) { return 1 - ramp(from_y(p, side_y), along_x, 0); },
                .parameters = {p(), along_x(), side_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(shadowed, ends_both),
                .number = 26,
                .formula = "along_x - q_y",
            },
            {
                .name = "rsmss/case_27",
                .source = "RBSM supplement, RSMSS case 27",
                .reference =
                    [](dvec2 p, double along_x, double along_y, unsigned side_x, unsigned side_y, int type_x,
                       int type_y) {
                        return 1 - std::min(ramp(from_x(p, side_x), along_y, type_y),
                                            ramp(from_y(p, side_y), along_x, type_x));
                    },
                .parameters = {p(), along_x(), along_y(), side_x(), side_y(), type_x(), type_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = any_corner(shadowed, goes_on_both),
                .number = 27,
                .formula = "max(X_x, X_y)",
            },
            {
                .name = "rsmss/case_28",
                .source = "RBSM supplement, RSMSS case 28",
                .reference = [](dvec2 p, unsigned side_y) { return 1 - ramp(from_y(p, side_y), 0, 1); },
                .parameters = {p(), side_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_x(shadowed, one, closed)},
                .number = 28,
                .formula = "1 - q_y",
            },
            {
                .name = "rsmss/case_29",
                .source = "RBSM supplement, RSMSS case 29",
                .reference = [](dvec2 p, unsigned side_x) { return 1 - ramp(from_x(p, side_x), 0, 1); },
                .parameters = {p(), side_x()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_y(shadowed, one, closed)},
                .number = 29,
                .formula = "1 - q_x",
            },
            {
                .name = "rsmss/case_30",
                .source = "RBSM supplement, RSMSS case 30",
                .reference = [](dvec2 p, double along_x,
                                unsigned side_y) { return 1 - ramp(from_y(p, side_y), along_x, 0); },
                .parameters = {p(), along_x(), side_y()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_x(shadowed, one, one_end)},
                .number = 30,
                .formula = "along_x - q_y",
            },
            {
                .name = "rsmss/case_31",
                .source = "RBSM supplement, RSMSS case 31",
                .reference = [](dvec2 p, double along_y,
                                unsigned side_x) { return 1 - ramp(from_x(p, side_x), along_y, 0); },
                .parameters = {p(), along_y(), side_x()},
                .result = visibility,
                .tolerance = three_roundings,
                .exact_where = on_grid,
                .condition = {run_along_y(shadowed, one, one_end)},
                .number = 31,
                .formula = "along_y - q_x",
            },
            {
                .name = "rsmss/decision",
                .source = "RBSM supplement, RSMSS cases 1 to 31; docs/revectorization.md 4.1",
                .reference =
                    [](bool entering, uvec2 sides, glm::ivec2 type, glm::bvec2 dominant) {
                        return number_by_conditions(table(), {sides, {}, type, dominant, entering});
                    },
                .parameters = {entering(), sides(), type(), dominant()},
                .result = {0, 31, "1", "the case's number, 0 for none"},
            },
            {
                .name = "rsmss/number",
                .source = "docs/revectorization.md 4",
                .reference =
                    [](const Mask& mask, glm::ivec2 texel) {
                        return number_by_conditions(table(), reference::edge(mask, texel));
                    },
                .parameters = {texel()},
                .result = {0, 31, "1", "the case's number, 0 for none"},
            },
            {
                .name = "rsmss/with_options",
                .source = "RBSM supplement, section 3; reference: distances in the plane of the mask",
                .reference = reference::rsmss_visibility_in_mask_space,
                .parameters = {texel(), p(), options()},
                .result = visibility,
                .tolerance = through_a_run,
            },
            {
                .name = "rsmss/visibility",
                .source = "RBSM supplement, section 3; reference: distances in the plane of the mask",
                .reference =
                    [](const Mask& mask, glm::ivec2 texel, dvec2 p) {
                        return reference::rsmss_visibility_in_mask_space(mask, texel, p, 0);
                    },
                .parameters = {texel(), p()},
                .result = visibility,
                .tolerance = through_a_run,
            },
        }};
    return family;
}

} // namespace

Family rsmss_family() { return table(); }

} // namespace gnomon
