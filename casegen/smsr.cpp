// The table of kernels/smsr: the twelve cases, the decision list over them, and their assembly.
//
// `applies` is each case's own condition (docs/revectorization.md 2.2), written for itself: that exactly one
// holds for every edge a lit texel can have is what the decision list is tested against.
#include "casegen/catalogue.h"
#include "casegen/reference/mask_space.h"
#include "casegen/vocabulary.h"

#include <algorithm>

namespace gnomon {

using namespace vocabulary;
using glm::dvec2;

namespace {

using reference::Edge;

// The kinds of edge. A BOTH counts by the run along it, for across it both walks end at once.
bool along_x_only(const Edge& e) { return e.sides.x == neither && e.sides.y != neither; }
bool along_y_only(const Edge& e) { return e.sides.y == neither && e.sides.x != neither; }
bool corner(const Edge& e) {
    return (e.sides.x == minus || e.sides.x == plus) && (e.sides.y == minus || e.sides.y == plus);
}
bool three_sides(const Edge& e) {
    return e.sides.x != neither && e.sides.y != neither && (e.sides.x == both || e.sides.y == both);
}
/// A corner whose runs both have one end: what cases 4 to 8 choose between by dominance.
bool open_corner(const Edge& e) { return corner(e) && e.type.x != 1 && e.type.y != 1; }

bool any_type(const Edge& e, int type) {
    return (along_x_only(e) && e.type.x == type) || (along_y_only(e) && e.type.y == type);
}

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

unsigned number_by_conditions(const Edge& e) {
    unsigned number = 0;
    for (const Case& c : table().cases)
        if (c.number != 0 && c.applies(e)) number = number == 0 ? c.number : 99; // 99: two conditions hold
    return number;
}

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
                .applies = [](const Edge& e) { return any_type(e, -1); },
                .number = 1,
            },
            {
                .name = "smsr/case_02",
                .source = "RBSM supplement, SMSR case 2",
                .reference = [](dvec2) { return 0.0; },
                .parameters = {p()},
                .result = visibility,
                .applies = [](const Edge& e) { return any_type(e, 1) || (corner(e) && !open_corner(e)); },
                .number = 2,
            },
            {
                .name = "smsr/case_03",
                .source = "RBSM supplement, SMSR case 3",
                .reference = [](dvec2) { return 0.0; },
                .parameters = {p()},
                .result = visibility,
                .applies =
                    [](const Edge& e) {
                        return three_sides(e) || (along_x_only(e) && e.sides.y == both && e.type.x == 0) ||
                               (along_y_only(e) && e.sides.x == both && e.type.y == 0);
                    },
                .number = 3,
            },
            {
                .name = "smsr/case_04",
                .source = "RBSM supplement, SMSR case 4",
                .reference = [](dvec2 p, double along_y,
                                unsigned side_x) { return lit_unless(from_side_x(p, side_x) < along_y); },
                .parameters = {p(), along_y(), side_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .applies = [](const Edge& e) { return open_corner(e) && e.dominant.x && !e.dominant.y; },
                .number = 4,
            },
            {
                .name = "smsr/case_05",
                .source = "RBSM supplement, SMSR case 5",
                .reference = [](dvec2 p, double along_x,
                                unsigned side_y) { return lit_unless(from_side_y(p, side_y) < along_x); },
                .parameters = {p(), along_x(), side_y()},
                .result = visibility,
                .tolerance = one_rounding,
                .applies = [](const Edge& e) { return open_corner(e) && e.dominant.y && !e.dominant.x; },
                .number = 5,
            },
            {
                .name = "smsr/case_06",
                .source = "RBSM supplement, SMSR case 6",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_plus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .applies =
                    [](const Edge& e) {
                        return open_corner(e) && !e.dominant.x && !e.dominant.y && e.sides.y == plus;
                    },
                .number = 6,
            },
            {
                .name = "smsr/case_07",
                .source = "RBSM supplement, SMSR case 7",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_minus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .applies =
                    [](const Edge& e) {
                        return open_corner(e) && !e.dominant.x && !e.dominant.y && e.sides.y == minus;
                    },
                .number = 7,
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
                .applies = [](const Edge& e) { return open_corner(e) && e.dominant.x && e.dominant.y; },
                .number = 8,
            },
            {
                .name = "smsr/case_09",
                .source = "RBSM supplement, SMSR case 9",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_plus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = one_rounding,
                .applies =
                    [](const Edge& e) { return along_x_only(e) && e.sides.y == plus && e.type.x == 0; },
                .number = 9,
            },
            {
                .name = "smsr/case_10",
                .source = "RBSM supplement, SMSR case 10",
                .reference = [](dvec2 p, double along_x) { return lit_unless(from_minus_y(p) < along_x); },
                .parameters = {p(), along_x()},
                .result = visibility,
                .tolerance = exact(),
                .applies =
                    [](const Edge& e) { return along_x_only(e) && e.sides.y == minus && e.type.x == 0; },
                .number = 10,
            },
            {
                .name = "smsr/case_11",
                .source = "RBSM supplement, SMSR case 11",
                .reference = [](dvec2 p, double along_y) { return lit_unless(from_minus_x(p) < along_y); },
                .parameters = {p(), along_y()},
                .result = visibility,
                .tolerance = exact(),
                .applies =
                    [](const Edge& e) { return along_y_only(e) && e.sides.x == minus && e.type.y == 0; },
                .number = 11,
            },
            {
                .name = "smsr/case_12",
                .source = "RBSM supplement, SMSR case 12",
                .reference = [](dvec2 p, double along_y) { return lit_unless(from_plus_x(p) < along_y); },
                .parameters = {p(), along_y()},
                .result = visibility,
                .tolerance = one_rounding,
                .applies =
                    [](const Edge& e) { return along_y_only(e) && e.sides.x == plus && e.type.y == 0; },
                .number = 12,
            },
            {
                .name = "smsr/decision",
                .source = "RBSM supplement, SMSR cases 1 to 12; docs/revectorization.md 2.1",
                .reference =
                    [](glm::uvec2 sides, glm::ivec2 type, glm::bvec2 dominant) {
                        return number_by_conditions({sides, {}, type, dominant});
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
                        return mask.lit(texel.x, texel.y) ? number_by_conditions(reference::edge(mask, texel))
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
