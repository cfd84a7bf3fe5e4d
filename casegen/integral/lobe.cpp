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
    "an interval that ends before it begins is turned round; where the lobe is below e^-104 of its "
    "height there is nothing; an input that is not finite gives 0";

bool is_in(double lower, double upper, double x) { return x >= lower && x <= upper; }

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

/// Numbers that are not finite, and lobes of which no float is left: 1e6 of e^-104, times a slope's 1e8 and
/// then some.
std::optional<Bounds> of_nothing(std::span<const double> n) {
    if (const auto asked = not_finite_gives({})(n)) return asked;
    const bool is_faint = is_in(0, 2, n[0]) && is_in(0, 2, n[1]) && is_in(0, 1e8, n[2]) &&
                          is_in(-1e6, 1e6, n[3]) && n[2] * std::min(n[0], n[1]) > 104.01;
    if (!is_faint) return {};
    constexpr double next_to_nothing = 1e-30;
    return Bounds{{-next_to_nothing}, {next_to_nothing}};
}

Quantity of_lobe(const char* name, const char* equation, Truth (*truth)(const Arguments&), const char* unit,
                 const char* meaning) {
    return {name,
            std::string("Analytic Double Product Integrals, Appendix A, ") + equation,
            reference_by<double(dvec2, double, double)>(truth),
            {versines(), lambda(), mu()},
            {-largest, largest, unit, meaning},
            stiffness::lobes(),
            stiffness::is_lobe,
            turned_round,
            of_nothing};
}
/// A height beyond the domain makes a slope beyond the floats: the largest of them. (β is proportional to μ.)
std::optional<Bounds> slope_of_giant(std::span<const double> numbers) {
    if (const auto asked = of_nothing(numbers)) return asked;
    Arguments of_1{};
    std::ranges::copy(numbers, of_1.numbers.begin());
    of_1.numbers[3] = 1;
    if (!is_in(0, 2, numbers[0]) || !is_in(0, 2, numbers[1]) || !is_in(0, 1e8, numbers[2]) ||
        !stiffness::is_lobe(of_1))
        return {};
    const double slope = numbers[3] * fit_beta(of_1).value[0];
    if (std::abs(slope) < 1.001 * largest) return {};
    return exactly({std::copysign(largest, slope)});
}
Quantity of_ends(Quantity q, Truth (*truth)(const Arguments&)) {
    q.reference = reference_by<double(dvec2, double, double)>(truth);
    q.parameters.front() = ends();
    q.generator = stiffness::lobes_of_ends();
    q.where = stiffness::is_lobe_of_ends;
    q.outside = not_finite_gives({});
    return q;
}

/// Where sinh and cosh neither cancel nor overflow, and the ends leave their difference its digits.
bool is_gentle(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const double q = 0.5 * (n[1] - n[0]), m = n[2] * q;
    // …nor exp, of whichever end, denormal.
    return q > 0.01 && m > 0.5 && m < 40 && std::abs(n[3]) * std::exp(-n[2] * (1 - n[0])) > 1e-30;
}

/// `nothing`: of an axis of length 0, whose dot product is 0 all over the cell; `anything`: of what is no
/// number.
Quantity of_cell(const char* name, const char* source, Reference reference, double lower, double upper,
                 const char* meaning, const char* rule, Numbers nothing, Numbers anything) {
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
            rule,
            [nothing,
             not_finite = not_finite_gives(anything)](std::span<const double> n) -> std::optional<Bounds> {
                const std::optional<Bounds> asked = not_finite(n);
                return !asked && n[4] == 0 && n[5] == 0 && n[6] == 0 ? exactly(nothing) : asked;
            }};
}

/// A cell wider than a turn is a whole turn: (a, b) is then what x takes between two circles about the pole.
std::optional<dvec2> ends_of_ring(std::span<const double> n) {
    const double low = std::min(n[2], n[3]), high = std::max(n[2], n[3]);
    const double across = std::hypot(n[4], n[5]);
    if (!(std::isfinite(n[1]) && std::abs(n[1]) > nearest_pi && is_in(-7000, 7000, n[0]) &&
          is_in(0, nearest_pi, n[2]) && is_in(0, nearest_pi, n[3]) &&
          is_in(1e-30, 2, std::hypot(across, n[6]))))
        return {};
    const double polar = std::atan2(across, n[6]), opposite = pi - polar;
    const double b = is_in(low, high, polar) ? 1 : std::max(std::cos(low - polar), std::cos(high - polar));
    const double a =
        is_in(low, high, opposite) ? -1 : std::min(std::cos(low + polar), std::cos(high + polar));
    return dvec2(a, b);
}
/// `rule`, and of rings their interval, or its versines, to a few roundings of 1.
std::function<std::optional<Bounds>(std::span<const double>)>
with_rings(std::function<std::optional<Bounds>(std::span<const double>)> rule, bool versines) {
    return [rule = std::move(rule), versines](std::span<const double> n) {
        const std::optional<dvec2> ends = ends_of_ring(n);
        if (!ends) return rule(n);
        constexpr double few = 1e-6;
        const dvec2 want = versines ? 1.0 - *ends : *ends;
        return std::optional(Bounds{{want.x - few, want.y - few}, {want.x + few, want.y + few}});
    };
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
    Quantity beta = of_lobe("beta", "Equation 2", fit_beta, "radiance", "the fit's slope in x");
    beta.outside = slope_of_giant;
    beta.rule = std::string("a slope beyond the floats is the largest; ") + turned_round;
    const Quantity l2 = of_lobe("l2", "Equation 3 as the L2 norm", fit_l2, "radiance",
                                "root of the integral of (G - L)^2 over x");
    const Quantity l1 =
        of_lobe("l1", "Equation 3 as the L1 norm", fit_l1, "radiance", "integral of |G - L| over x");
    Quantity exact =
        of_cell("exact", "Analytic Double Product Integrals, Appendix A; docs/integrals.md, section 5",
                reference_by<dvec2(double, double, dvec2, dvec3)>(interval), -1, 1,
                "(a, b): the interval of the dot product",
                "reversed widths and edges are turned round, more than a turn is a whole turn; an axis of "
                "length 0 gives (0, 0); an input that is "
                "not finite gives (-1, 1)",
                {}, {-1, 1});
    Quantity versines = of_cell("versines", "docs/integrals.md, sections 4 and 5",
                                reference_by<dvec2(double, double, dvec2, dvec3)>(interval_versines), 0, 2,
                                "(1 - a, 1 - b) of the interval of the dot product",
                                "reversed widths and edges are turned round, more than a turn is a whole "
                                "turn; an axis of length 0 gives (1, 1); an input that is "
                                "not finite gives (2, 0)",
                                {1, 1}, {2, 0});
    Quantity corner = exact;
    corner.name = "corner";
    corner.source = "Analytic Double Product Integrals, Appendix A";
    corner.reference = corner_rule;
    exact.outside = with_rings(std::move(exact.outside), false);
    versines.outside = with_rings(std::move(versines.outside), true);
    std::vector<Case> cases;
    cases.push_back(in_form("interval", exact, conditioned(16)));
    cases.push_back(in_form("interval", versines, conditioned(16)));
    cases.push_back(good_where(in_form("interval", corner, absolute(1e-6)), is_off_the_edges));
    // Twice what `gnomon worst` finds, as is that of the errors.
    for (const Quantity& q : {r0, r1, beta, alpha}) cases.push_back(in_form("fit", q, conditioned(10)));
    for (const Quantity& q : {l2, l1}) cases.push_back(in_form("fit", q, conditioned(9)));
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
