// The radiance kernels of kernels/integral: Appendix B, Equation 5, whole.
#include "casegen/integral/quantity.h"
#include "casegen/reference/integral/truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::integral {
namespace {

using glm::dvec2, glm::dvec3;
constexpr double pi = std::numbers::pi;

Quantity radiance() {
    return {
        "radiance",
        "Analytic Double Product Integrals, Appendix B, Equation 5",
        reference_by<double(double, double, double, dvec2, dvec3, dvec3, double, double, dvec2)>(
            reference::integral::radiance),
        {{"phi", {-7000, 7000, {}}, "radians", "azimuth of the cell's middle, from x towards y"},
         {"half_width", {-nearest_pi, nearest_pi, {}}, "radians", "half the cell's width in azimuth"},
         {"theta0", {0, nearest_pi, {}}, "radians", "the edge towards the pole, from the pole"},
         {"rise",
          {-nearest_pi, nearest_pi, {}},
          "radians",
          "how far the boundary lies from theta0, at either end"},
         {"n", {-1, 1, {}}, "1", "the receiver's normal, in the cell's frame"},
         {"p", {-1, 1, {}}, "1", "the lobe's axis in the cell's frame; it is scaled to length 1"},
         {"lambda", {0, 1e8, {}}, "1", "the lobe's sharpness: mu e^(lambda (x - 1))"},
         {"mu", {-1e6, 1e6, {}}, "radiance", "the lobe's height"},
         {"versines",
          {0, 2, {}},
          "1",
          "1 - a and 1 - b of the interval a to b that the fit is made for: x = p.w in all of the cell lies "
          "in it"}},
        {-largest, largest, "radiance x steradians",
         "the fit of the lobe times n.w, over the cell under its boundary"},
        stiffness::lit_cells(),
        stiffness::is_lit_cell,
        "half_width below 0 is the cell from its other end, rise.x first, and negates, as does a boundary "
        "below theta0; versines are turned round; p must not be 0; a result beyond the floats is the largest "
        "or, where such cancel, 0; an input that is not finite gives 0",
        not_finite_gives({})};
}

struct Shape { // of a cell, in radians
    double half_width, theta0, first, last, wave, rise, lambda, q;
};
Shape shape_of(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const double half = std::abs(n[1]);
    return {half,
            n[2],
            n[2] + n[3],
            n[2] + n[4],
            1.5 * std::abs(n[4] - n[3]) + 2 * half,
            std::max(std::abs(n[3]), std::abs(n[4])),
            n[11],
            0.5 * std::abs(n[13] - n[14])};
}
/// Neither narrow nor near a pole nor a slab, under a lobe as wide and no brighter than 2.
bool is_wide(const Arguments& arguments) {
    const Shape s = shape_of(arguments);
    const auto is_inner = [](double theta) { return theta > 0.3 && theta < pi - 0.3; };
    return s.half_width > 0.1 && std::abs(arguments.numbers[0]) < 20 && is_inner(s.theta0) &&
           is_inner(s.first) && is_inner(s.last) && std::abs(0.5 * (s.first + s.last) - s.theta0) > 0.2 &&
           s.q > 0.1 && s.lambda < 40 && std::abs(s.last - s.first) < 5 * s.half_width &&
           std::abs(arguments.numbers[12]) < 2;
}
bool is_far_from_loci(const Arguments& arguments) {
    const Shape s = shape_of(arguments);
    const double k = std::abs(s.last - s.first) / (2 * s.half_width);
    for (const double locus : {0.0, 1.0 / 3, 0.5, 2.0 / 3, 1.0, 2.0})
        if (std::abs(k - locus) < 0.03) return false;
    return is_wide(arguments) && s.lambda * s.q > 0.5;
}

} // namespace

std::vector<Case> radiance_cases() {
    const Quantity q = radiance();
    const auto exact_theta = [&](const char* form, double most) {
        // So large that α and βx do not cancel, and of so few turns that the rule has nodes for them.
        return good_where(in_form(form, q, conditioned(200)), [most](const Arguments& arguments) {
            const Shape s = shape_of(arguments);
            return s.wave <= most && s.q > 0.05;
        });
    };
    const auto centred = [&](const char* form, double most) {
        return good_where(in_form(form, q, conditioned(40)), [most](const Arguments& arguments) {
            const Shape s = shape_of(arguments);
            return s.wave <= most && 1.5 * s.rise <= most;
        });
    };
    const auto columns = [&](const char* form, double most) {
        return good_where(in_form(form, q, conditioned(8)),
                          [most](const Arguments& arguments) { return shape_of(arguments).wave <= most; });
    };
    // The numbers are what hill-climbing on the inputs' bits finds by columns (fixtures/worst), with room to
    // spare; ordinary and stiff inputs stay at about 2. Of exact_theta and centred it finds some far beyond
    // theirs. docs/integrals.md, 6 has the tables.
    std::vector<Case> cases;
    cases.push_back(columns("columns_4", 0.6));
    cases.push_back(columns("columns_8", 4));
    cases.push_back(in_form("columns_12", q, conditioned(8)));
    cases.push_back(in_form("columns_16", q, conditioned(8)));
    cases.push_back(in_form("mix", q, conditioned(8)));
    cases.push_back(centred("centred_4", 0.6));
    cases.push_back(centred("centred_8", 4));
    cases.push_back(centred("centred_12", 8));
    cases.push_back(exact_theta("exact_theta_4", 0.6));
    cases.push_back(exact_theta("exact_theta_8", 4));
    cases.push_back(exact_theta("exact_theta", 8));
    cases.push_back(good_where(in_form("sinc", q, conditioned(400)), is_wide));
    cases.push_back(as_printed(in_form("printed", q, conditioned(4000)), is_far_from_loci));
    Case exactly = in_form("as_printed", q, conditioned(4000));
    exactly.defended = false;
    exactly.outside = nullptr;
    exactly.fails = "B0 asks for C4 at s = 1, where it divides by zero: never a number";
    exactly.rule = "as printed: NaN";
    cases.push_back(std::move(exactly));
    return cases;
}

} // namespace gnomon::integral
