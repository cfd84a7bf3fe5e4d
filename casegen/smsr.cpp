// The table of kernels/smsr: the twelve cases, the decision list over them, and their assembly.
//
// Each case's condition is written for itself (docs/revectorization.md 2.2): that exactly one holds for every
// edge a lit texel can have is what the decision list is tested against.
#include "casegen/catalogue.h"
#include "casegen/reference/mask_space.h"
#include "casegen/vocabulary.h"

#include <algorithm>

namespace gnomon {

using namespace vocabulary;
using glm::dvec2;

namespace {

using reference::Edge;

/// A corner whose runs both have one end: what cases 4 to 8 choose between by dominance.
Condition open_corner(unsigned side_y, unsigned dominant) {
    return corner(sets::lit, sets::one, side_y, sets::one_end, sets::one_end, dominant);
}

constexpr unsigned not_closed = sets::open | sets::one_end;

// Distances from the shadowed side of the texel, as fractions of it.
double from_plus_y(dvec2 p) { return 1 - p.y; }
double from_minus_y(dvec2 p) { return p.y; }
double from_minus_x(dvec2 p) { return p.x; }
double from_plus_x(dvec2 p) { return 1 - p.x; }
double lit_unless(bool shadow) { return shadow ? 0 : 1; }
double from_side_x(dvec2 p, unsigned side) { return side == minus ? from_minus_x(p) : from_plus_x(p); }
double from_side_y(dvec2 p, unsigned side) { return side == plus ? from_plus_y(p) : from_minus_y(p); }

/// Half an ulp below 1, for 1 - p rounded to float, and as much for the position along the run.
const Tolerance one_rounding = input_within(0x1p-24);

const Family& table();

const Family& table() {
    const Result visibility{0, 1, "1", "1 lit, 0 shadowed"};
    static const Family family{
        "smsr",
        "silhouette revectorisation: 12 cases, the decision list, and the assembled visibility",
        {
            {
                .name = "smsr/case_01",
                .source = "RBSM supplement, SMSR case 1",
                .reference = [](dvec2) { return 1.0; },
                .parameters = {p()},
                .result = visibility,
                .condition = {run_along_x(sets::lit, sets::some, sets::open),
                              run_along_y(sets::lit, sets::some, sets::open)},
                .number = 1,
                .formula = "1",
            },
            {
                .name = "smsr/case_02",
                .source = "RBSM supplement, SMSR case 2",
                .reference = [](dvec2) { return 0.0; },
                .parameters = {p()},
                .result = visibility,
                .condition =
                    {run_along_x(sets::lit, sets::some, sets::closed),
                     run_along_y(sets::lit, sets::some, sets::closed),
                     {.light = sets::lit, .side_x = sets::both, .side_y = sets::one, .type_y = sets::closed},
                     {.light = sets::lit, .side_x = sets::one, .side_y = sets::both, .type_x = sets::closed},
                     corner(sets::lit, sets::one, sets::one, sets::closed, sets::any_type,
                            sets::any_dominance),
                     corner(sets::lit, sets::one, sets::one, sets::any_type, sets::closed,
                            sets::any_dominance)},
                .number = 2,
                .formula = "0",
            },
            {
                .name = "smsr/case_03",
                .source = "RBSM supplement, SMSR case 3",
                .reference = [](dvec2) { return 0.0; },
                .parameters = {p()},
                .result = visibility,
                .condition =
                    {{.light = sets::lit, .side_x = sets::both, .side_y = sets::both},
                     {.light = sets::lit, .side_x = sets::both, .side_y = sets::one, .type_y = not_closed},
                     {.light = sets::lit, .side_x = sets::one, .side_y = sets::both, .type_x = not_closed},
                     run_along_x(sets::lit, sets::both, sets::one_end),
                     run_along_y(sets::lit, sets::both, sets::one_end)},
                .number = 3,
                .formula = "0",
            },
            {
                .name = "smsr/case_04",
                .source = "RBSM supplement, SMSR case 4",
                .reference = [](dvec2 p, double along_y,
                                unsigned side_x) { return lit_unless(from_side_x(p, side_x) < along_y); },
                .parameters = {p(), along_y(), side_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .exact_where = on_grid,
                .condition = {open_corner(sets::one, sets::goes_on_x)},
                .number = 4,
                .formula = "0 if q_x < along_y; 1 otherwise",
            },
            {
                .name = "smsr/case_05",
                .source = "RBSM supplement, SMSR case 5",
                .reference = [](dvec2 p, double along_x,
                                unsigned side_y) { return lit_unless(from_side_y(p, side_y) < along_x); },
                .parameters = {p(), along_x(), side_y()},
                .result = visibility,
                .tolerance = one_rounding,
                .exact_where = on_grid,
                .condition = {open_corner(sets::one, sets::goes_on_y)},
                .number = 5,
                .formula = "0 if q_y < along_x; 1 otherwise",
            },
            {
                .name = "smsr/case_06",
                .source = "RBSM supplement, SMSR case 6",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_plus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .exact_where = on_grid,
                .condition = {open_corner(sets::plus, sets::ends_both)},
                .number = 6,
                .formula = "0 if 1 - p.y < along_x; 1 otherwise",
            },
            {
                .name = "smsr/case_07",
                .source = "RBSM supplement, SMSR case 7",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_minus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .exact_where = on_grid,
                .condition = {open_corner(sets::minus, sets::ends_both)},
                .number = 7,
                .formula = "0 if p.y < along_x; 1 otherwise",
            },
            {
                .name = "smsr/case_08",
                .source = "RBSM supplement, SMSR case 8",
                .reference =
                    [](dvec2 p, double along_x, double along_y, unsigned side_x, unsigned side_y) {
                        return lit_unless(from_side_y(p, side_y) < along_x ||
                                          from_side_x(p, side_x) < along_y);
                    },
                .parameters = {p(), along_x(), along_y(), side_x(), side_y()},
                .result = visibility,
                .tolerance = one_rounding,
                .exact_where = on_grid,
                .condition = {open_corner(sets::one, sets::goes_on_both)},
                .number = 8,
                .formula = "0 if q_y < along_x; 0 if q_x < along_y; 1 otherwise",
            },
            {
                .name = "smsr/case_09",
                .source = "RBSM supplement, SMSR case 9",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_plus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .exact_where = on_grid,
                .condition = {run_along_x(sets::lit, sets::plus, sets::one_end)},
                .number = 9,
                .formula = "0 if 1 - p.y < along_x; 1 otherwise",
            },
            {
                .name = "smsr/case_10",
                .source = "RBSM supplement, SMSR case 10",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_minus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = exact(),
                .condition = {run_along_x(sets::lit, sets::minus, sets::one_end)},
                .number = 10,
                .formula = "0 if p.y < along_x; 1 otherwise",
            },
            {
                .name = "smsr/case_11",
                .source = "RBSM supplement, SMSR case 11",
                .reference = [](dvec2 p, double along_y) { return lit_unless(from_minus_x(p) < along_y); },
                .parameters = {p(), along_y()},
                .result = visibility,
                .tolerance = exact(),
                .condition = {run_along_y(sets::lit, sets::minus, sets::one_end)},
                .number = 11,
                .formula = "0 if p.x < along_y; 1 otherwise",
            },
            {
                .name = "smsr/case_12",
                .source = "RBSM supplement, SMSR case 12",
                .reference = [](dvec2 p, double along_y) { return lit_unless(from_plus_x(p) < along_y); },
                .parameters = {p(), along_y()},
                .result = visibility,
                .tolerance = one_rounding,
                .exact_where = on_grid,
                .condition = {run_along_y(sets::lit, sets::plus, sets::one_end)},
                .number = 12,
                .formula = "0 if 1 - p.x < along_y; 1 otherwise",
            },
            {
                .name = "smsr/decision",
                .source = "RBSM supplement, SMSR cases 1 to 12; docs/revectorization.md 2.1",
                .reference =
                    [](glm::uvec2 sides, glm::ivec2 type, glm::bvec2 dominant) {
                        return number_by_conditions(table(), {sides, {}, type, dominant});
                    },
                .parameters = {sides(), type(), dominant()},
                .result = {0, 12, "1", "the case's number, 0 for none"},
                .where =
                    [](const Arguments& a) { // a corner's run ends at the other side's shadow: never open at
                                             // both ends
                        const bool is_corner = a.numbers[0] != 0 && a.numbers[1] != 0;
                        return !is_corner || (a.numbers[2] != -1 && a.numbers[3] != -1);
                    },
            },
            {
                .name = "smsr/number",
                .source = "docs/revectorization.md 2",
                .reference =
                    [](const Mask& mask, glm::ivec2 texel) {
                        return mask.lit(texel.x, texel.y)
                                   ? number_by_conditions(table(), reference::edge(mask, texel))
                                   : 0u;
                    },
                .parameters = {texel()},
                .result = {0, 12, "1", "the case's number, 0 for none"},
            },
            {
                .name = "smsr/visibility",
                .source = "RBSM supplement, section 2; reference: lines in the plane of the mask",
                .reference = reference::smsr_visibility_in_mask_space,
                .parameters = {texel(), p()},
                .result = visibility,
                // The position along a run of up to 16 texels is rounded to 2^-22 (revectorize/along): the
                // step moves
                // by that in units of p across the run, and by 16 times as much along it.
                .tolerance = input_within(0x1p-18),
            },
        }};
    return family;
}

} // namespace

Family smsr_family() { return table(); }

} // namespace gnomon
