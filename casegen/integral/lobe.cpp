// kernels/integral/interval, fit and fit_printed: Appendix A.
#include "casegen/integral/quantity.h"
#include "casegen/reference/integral/truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::integral {
namespace {

using namespace reference::integral;
using glm::dvec2, glm::dvec3;
constexpr double pi = std::numbers::pi;

const char* turned_round =
    "an interval that ends before it begins is turned round; an input that is not finite gives 0";

Parameter versines() {
    return {"versines",
            {0, 2, {}},
            "1",
            "1 - a and 1 - b of the interval a to b of x, the dot product with the lobe's axis"};
}
Parameter ends() {
    return {"ends", {-1, 1, {}}, "1", "a and b: the interval of x, the dot product with the lobe's axis"};
}
Parameter lambda() { return {"lambda", {0, 1e8, {}}, "1", "the lobe's sharpness: mu e^(lambda (x - 1))"}; }
Parameter mu() { return {"mu", {-1e6, 1e6, {}}, "radiance", "the lobe's height"}; }

Quantity of_lobe(const char* name, const char* equation, Truth (*truth)(const Arguments&), const char* unit,
                 const char* meaning) {
    return {name,
            std::string("Analytic Double Product Integrals, Appendix A, ") + equation,
            reference_by<double(dvec2, double, double)>(truth),
            {versines(), lambda(), mu()},
            {-largest, largest, unit, meaning},
            stiffness::lobes(),
            stiffness::is_lobe,
            turned_round};
}
Quantity of_ends(Quantity q, Truth (*truth)(const Arguments&)) {
    q.reference = reference_by<double(dvec2, double, double)>(truth);
    q.parameters.front() = ends();
    q.generator = stiffness::lobes_of_ends();
    q.where = stiffness::is_lobe_of_ends;
    return q;
}

/// Where sinh and cosh neither cancel nor overflow, and the ends leave their difference its digits.
bool is_gentle(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const double q = 0.5 * (n[1] - n[0]), m = n[2] * q;
    // …nor exp, of whichever end, denormal.
    return q > 0.01 && m > 0.5 && m < 40 && std::abs(n[3]) * std::exp(-n[2] * (1 - n[0])) > 1e-30;
}

Quantity of_cell(const char* name, const char* source, Reference reference, double lower, double upper,
                 const char* meaning, const char* rule) {
    return {name,
            source,
            std::move(reference),
            {{"phi", {-7000, 7000, {}}, "radians", "azimuth of the cell's middle, from x towards y"},
             {"half_width", {-nearest_pi, nearest_pi, {}}, "radians", "half the cell's width in azimuth"},
             {"theta", {0, nearest_pi, {}}, "radians", "the cell's edges, from the pole"},
             {"p", {-1, 1, {}}, "1", "the lobe's axis; its length does not matter"}},
            {lower, upper, "1", meaning},
            stiffness::cells_and_axes(),
            stiffness::is_cell_and_axis,
            rule};
}

/// Appendix A to the letter: corners, and whether the axis or its opposite lies between the edges.
dvec2 corner_rule(double phi, double half_width, dvec2 theta, dvec3 p) {
    p = glm::normalize(p);
    double a = 1, b = -1;
    for (const double f : {phi - half_width, phi + half_width})
        for (const double t : {theta.x, theta.y}) {
            const double dot = std::sin(t) * (std::cos(f) * p.x + std::sin(f) * p.y) + std::cos(t) * p.z;
            a = std::min(a, dot);
            b = std::max(b, dot);
        }
    const auto holds = [&](dvec3 axis) {
        const double polar = std::acos(std::clamp(axis.z, -1.0, 1.0));
        const double across = std::remainder(std::atan2(axis.y, axis.x) - phi, 2 * pi);
        return std::abs(across) <= std::abs(half_width) && polar >= std::min(theta.x, theta.y) &&
               polar <= std::max(theta.x, theta.y);
    };
    if (holds(p)) b = 1;
    if (holds(-p)) a = -1;
    return {a, b};
}
/// Whether no rounding of the inputs brings an axis into the cell or takes it out: the corners' rule jumps
/// there.
bool is_off_the_edges(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const dvec3 p(n[4], n[5], n[6]);
    const double u = std::hypot(p.x, p.y), polar = std::atan2(u, p.z);
    if (u < 1e-3 || std::abs(n[1]) < 1e-3 || std::abs(n[1]) > pi - 1e-3) return false;
    for (const dvec3 axis : {p, -p}) {
        const double across = std::abs(std::remainder(std::atan2(axis.y, axis.x) - n[0], 2 * pi));
        const double own_polar = axis.z == p.z && axis.x == p.x ? polar : pi - polar;
        if (std::abs(across - std::abs(n[1])) < 1e-3 || std::abs(own_polar - n[2]) < 1e-3 ||
            std::abs(own_polar - n[3]) < 1e-3)
            return false;
    }
    return true;
}

} // namespace

std::vector<Case> lobe_cases() {
    const Quantity r0 = of_lobe("r0", "Equation 1", fit_r0, "radiance", "the fit's mean");
    const Quantity r1 =
        of_lobe("r1", "Equation 1", fit_r1, "radiance", "the fit's slope over half the interval");
    const Quantity alpha = of_lobe("alpha", "Equation 2", fit_alpha, "radiance", "the fit's value at x = 0");
    const Quantity beta = of_lobe("beta", "Equation 2", fit_beta, "radiance", "the fit's slope in x");
    const Quantity l2 = of_lobe("l2", "Equation 3 as the L2 norm", fit_l2, "radiance",
                                "root of the integral of (G - L)^2 over x");
    const Quantity l1 =
        of_lobe("l1", "Equation 3 as the L1 norm", fit_l1, "radiance", "integral of |G - L| over x");
    const Quantity exact =
        of_cell("exact", "Analytic Double Product Integrals, Appendix A; docs/integrals.md, section 5",
                reference_by<dvec2(double, double, dvec2, dvec3)>(interval), -1, 1,
                "(a, b): the interval of the dot product",
                "reversed widths and edges are turned round; an input that is not finite gives (-1, 1)");
    const Quantity versines =
        of_cell("versines", "docs/integrals.md, sections 4 and 5",
                reference_by<dvec2(double, double, dvec2, dvec3)>(interval_versines), 0, 2,
                "(1 - a, 1 - b) of the interval of the dot product",
                "reversed widths and edges are turned round; an input that is not finite gives (2, 0)");
    Quantity corner = exact;
    corner.name = "corner";
    corner.source = "Analytic Double Product Integrals, Appendix A";
    corner.reference = corner_rule;
    std::vector<Case> cases;
    cases.push_back(in_form("interval", exact, conditioned(16)));
    cases.push_back(in_form("interval", versines, conditioned(16)));
    cases.push_back(good_where(in_form("interval", corner, absolute(1e-6)), is_off_the_edges));
    for (const Quantity& q : {r0, r1, beta, alpha}) cases.push_back(in_form("fit", q, conditioned(12)));
    for (const Quantity& q : {l2, l1}) cases.push_back(in_form("fit", q, conditioned(16)));
    for (const auto& [q, truth] :
         {std::pair{r0, &fit_r0_of_ends}, std::pair{r1, &fit_r1_of_ends},
          std::pair{alpha, &fit_alpha_of_ends}, std::pair{beta, &fit_beta_of_ends}}) {
        Case c = as_printed(in_form("fit_printed", of_ends(q, truth), conditioned(100)), is_gentle);
        c.quantity += "_of_ends";
        cases.push_back(std::move(c));
    }
    return cases;
}

} // namespace gnomon::integral
