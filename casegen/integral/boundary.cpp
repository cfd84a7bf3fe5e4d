// A0 … B of kernels/integral: Appendix B, Equations 8 to 15, over cells under a linear boundary; and those
// cells' other form.
#include "casegen/integral/quantity.h"
#include "casegen/reference/integral/number.h"
#include "casegen/reference/integral/truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::integral {
namespace {

using namespace reference::integral;
using glm::dvec3;
using stiffness::Trailing;
constexpr double pi = std::numbers::pi;

std::vector<Parameter> cell() {
    return {{"phi0", {-7000, 7000, {}}, "radians", "the azimuth where the cell begins, from x towards y"},
            {"phi1", {-7000, 7000, {}}, "radians", "where it ends"},
            {"theta0", {0, nearest_pi, {}}, "radians", "the edge towards the pole, from the pole"},
            {"k", {-1e7, 1e7, {}}, "1", "the boundary's slope: theta = k phi + b"},
            {"b", {-1e9, 1e9, {}}, "radians", "the boundary's height at azimuth 0"}};
}
Parameter phase(const char* name) {
    return {name,
            {-7, 7, {}},
            "radians",
            "the vector's azimuth from y towards x: x cos(phi) + y sin(phi) = u sin(phi + it)"};
}
Parameter vector(const char* name, const char* meaning) { return {name, {-2, 2, {}}, "1", meaning}; }

Quantity over_cell(const char* name, int equation, Reference reference, Trailing trailing,
                   std::vector<Parameter> rest, const char* meaning) {
    std::vector<Parameter> parameters = cell();
    parameters.insert(parameters.end(), rest.begin(), rest.end());
    return {name,
            "Analytic Double Product Integrals, Appendix B, Equation " + std::to_string(equation),
            std::move(reference),
            std::move(parameters),
            {-largest, largest, "steradians", meaning},
            stiffness::boundary_cells(trailing),
            stiffness::is_boundary_cell,
            "a reversed interval of phi, or a boundary below theta0, negates; an input that is not finite "
            "gives 0",
            not_finite_gives({})};
}

double height(const Arguments& arguments, std::size_t end) {
    const auto& n = arguments.numbers;
    return n[3] * n[end] + n[4];
}

/// Where waves of the cell's own angles neither cancel nor carry a large rounding: no slab, no pole, not
/// steep.
bool is_wide(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const double first = height(arguments, 0), last = height(arguments, 1);
    const auto is_inner = [](double theta) { return theta > 0.3 && theta < pi - 0.3; };
    return std::abs(n[1] - n[0]) > 0.2 && std::abs(n[0]) < 20 && std::abs(n[1]) < 20 && std::abs(n[3]) < 5 &&
           is_inner(n[2]) && is_inner(first) && is_inner(last) && std::abs(0.5 * (first + last) - n[2]) > 0.2;
}
/// And no denominator of the printed forms small.
bool is_far_from_loci(const Arguments& arguments) {
    const double k = std::abs(arguments.numbers[3]);
    for (const double locus : {0.0, 1.0 / 3, 0.5, 2.0 / 3, 1.0, 2.0})
        if (std::abs(k - locus) < 0.03) return false;
    return is_wide(arguments);
}

glm::dvec4 from_boundary(double phi0, double phi1, double theta0, double k, double b) {
    // In multiprecision: kφ and b may be large and cancel to a few bits of θ0.
    const auto above = [&](double phi) {
        return static_cast<double>(Real(k) * phi + Real(b) - Real(theta0));
    };
    return {0.5 * (phi0 + phi1), 0.5 * (phi1 - phi0), above(phi0), above(phi1)};
}

/// An end whose kφ is no float has no height.
std::optional<Bounds> beyond_the_floats(std::span<const double> n) {
    if (const auto asked = not_finite_gives({})(n)) return asked;
    Bounds bounds = exactly({-largest, -largest, -largest, -largest});
    bounds.upper = {largest, largest, largest, largest};
    for (const std::size_t end : {0u, 1u})
        if (std::abs(n[3] * n[end]) > 2 * largest) bounds.lower[2 + end] = bounds.upper[2 + end] = 0;
    return bounds;
}

} // namespace

std::vector<Case> boundary_cases() {
    using Cell = double(double, double, double, double, double);
    using Angle = double(double, double, double, double, double, double);
    using Angles = double(double, double, double, double, double, double, double);
    using Vector = double(double, double, double, double, double, dvec3);
    using Vectors = double(double, double, double, double, double, dvec3, dvec3);
    const Parameter n = vector("n", "the receiver's normal times its albedo, in the cell's frame");
    const Parameter p = vector("p", "the lobe's axis times the fit's slope, in the cell's frame");
    const std::vector<Quantity> parts{
        over_cell("a0", 9, reference_by<Angle>(a0), Trailing::angle, {phase("tau")},
                  "integral of sin(phi + tau) sin^2(theta)"),
        over_cell("a1", 10, reference_by<Cell>(a1), Trailing::nothing, {},
                  "integral of cos(theta) sin(theta)"),
        over_cell("b0", 12, reference_by<Angles>(b0), Trailing::two_angles, {phase("gamma"), phase("tau")},
                  "integral of sin(phi + gamma) sin(phi + tau) sin^3(theta)"),
        over_cell("b1", 13, reference_by<Angle>(b1), Trailing::angle, {phase("gamma")},
                  "integral of sin(phi + gamma) cos(theta) sin^2(theta)"),
        over_cell("b2", 14, reference_by<Angle>(b2), Trailing::angle, {phase("tau")},
                  "integral of sin(phi + tau) cos(theta) sin^2(theta)"),
        over_cell("b3", 15, reference_by<Cell>(b3), Trailing::nothing, {},
                  "integral of cos^2(theta) sin(theta)"),
    };
    const std::vector<Quantity> wholes{
        over_cell("a", 8, reference_by<Vector>(a), Trailing::vector, {n}, "integral of n.w over solid angle"),
        over_cell("b", 11, reference_by<Vectors>(b), Trailing::two_vectors, {n, p},
                  "integral of (p.w)(n.w) over solid angle"),
    };
    std::vector<Case> cases;
    // The printed forms and the waves subtract terms of the order of 1, and the wholes those times |n| and
    // |p|: so absolute errors, three times the largest that `gnomon worst` finds.
    const auto add = [&](const Quantity& q, double printed, double sinc) {
        cases.push_back(as_printed(in_form("printed", q, absolute(printed)), is_far_from_loci));
        cases.push_back(good_where(in_form("sinc", q, absolute(sinc)), is_wide));
        cases.push_back(in_form("exact_theta", q, conditioned(24)));
    };
    for (const Quantity& q : parts) add(q, 2e-5, 1e-5);
    add(wholes[0], 1e-4, 1e-4);
    add(wholes[1], 5e-4, 5e-4);
    for (const Quantity& q : wholes) {
        const auto turns = [](const Arguments& arguments,
                              double most) { // radians of the fastest wave on half the width
            const auto& v = arguments.numbers;
            return (3 * std::abs(v[3]) + 2) * 0.5 * std::abs(v[1] - v[0]) <= most;
        };
        cases.push_back(good_where(in_form("exact_theta_4", q, conditioned(10)),
                                   [turns](const Arguments& with) { return turns(with, 0.6); }));
        cases.push_back(good_where(in_form("exact_theta_8", q, conditioned(12)),
                                   [turns](const Arguments& with) { return turns(with, 4); }));
    }
    for (const char* name : {"b0", "b"}) {
        const auto& list = name[1] == '0' ? parts : wholes;
        Case c = in_form("as_printed", *std::ranges::find(list, name, &Quantity::name), absolute(1e-3));
        c.defended = false;
        c.outside = nullptr;
        c.fails = "B0 asks for C4 at s = 1, where it divides by zero: never a number";
        c.rule = "as printed: NaN";
        cases.push_back(std::move(c));
    }
    cases.push_back({
        .name = "integral/cell/from_boundary",
        .source = "docs/integrals.md, section 3",
        .reference = from_boundary,
        .parameters = cell(),
        .result = {-largest, largest, "radians",
                   "phi in the middle, half the width, the boundary above theta0 at phi0 and at phi1"},
        .tolerance = ulps(2),
        .where = [](const Arguments& arguments) { return stiffness::is_boundary_cell(arguments); },
        .generator = stiffness::boundary_cells(Trailing::nothing),
        .rule = "a height is 0 if k phi is beyond the floats; an input that is not finite gives 0",
        .outside = beyond_the_floats,
    });
    cases.push_back({
        .name = "integral/cell/from_south",
        .source = "docs/integrals.md, section 3",
        .reference =
            [](double theta) {
                return static_cast<double>(std::numbers::pi_v<long double> - static_cast<long double>(theta));
            },
        .parameters = {{"theta", {0, nearest_pi, {}}, "radians", "the angle from the pole"}},
        .result = {-largest, largest, "radians", "the angle from the opposite pole"},
        .tolerance = ulps(2),
        .rule = "an input that is not finite gives 0",
        .outside = not_finite_gives({}),
    });
    return cases;
}

} // namespace gnomon::integral
