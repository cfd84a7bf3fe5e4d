// What integrals over cells are known to be, and what moving, cutting and turning cells round does to them.
#include "casegen/reference/integral/cell.h"
#include "casegen/reference/integral/truth.h"
#include "casegen/reference/integral/values.h"
#include "tests/integral/inputs.h"

#include <boost/math/constants/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gnomon::testing {
namespace {

namespace ri = reference::integral;
using ri::Cell;
using ri::Moments;
using ri::Real;

const Real pi = boost::math::constants::pi<Real>();
const std::array<Real, 3> x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

void expect_near(const Real& got, const Real& want, double scale = 1) {
    EXPECT_LE(static_cast<double>(Real(abs(got - want))), 1e-28 * scale) << got << " " << want;
}

/// φ from 0 for a whole turn, θ from `first` to `last`.
Moments<Real> band(const Real& first, const Real& last) {
    return ri::moments({pi, pi, first, last - first, last - first});
}

TEST(integrals, of_whole_spheres_and_halves) {
    const Moments<Real> sphere = band(0, pi), upper = band(0, pi / 2);
    expect_near(ri::first_moment(upper, z_axis.data()), pi);
    expect_near(ri::first_moment(upper, x_axis.data()), 0);
    expect_near(ri::first_moment(sphere, z_axis.data()), 0);
    for (const auto& n : {x_axis, y_axis, z_axis}) {
        expect_near(ri::second_moment(sphere, n.data(), n.data()), 4 * pi / 3);
        expect_near(ri::second_moment(upper, n.data(), n.data()), 2 * pi / 3);
    }
    expect_near(ri::second_moment(sphere, x_axis.data(), y_axis.data()), 0);
    expect_near(ri::second_moment(sphere, x_axis.data(), z_axis.data()), 0);
}

TEST(integrals, of_an_octant_and_of_under_a_slope) {
    const Moments<Real> octant = ri::moments({pi / 4, pi / 4, 0, pi / 2, pi / 2});
    for (const auto& n : {x_axis, y_axis, z_axis}) expect_near(ri::first_moment(octant, n.data()), pi / 4);
    expect_near(ri::second_moment(octant, x_axis.data(), y_axis.data()), Real(1) / 3);
    expect_near(ri::second_moment(octant, y_axis.data(), z_axis.data()), Real(1) / 3);
    // θ < φ/2: ∫ ½ sin²(φ/2) dφ over half a turn.
    const Moments<Real> sloped = ri::moments({pi / 2, pi / 2, 0, 0, pi / 2});
    expect_near(ri::first_moment(sloped, z_axis.data()), pi / 4);
}

TEST(integrals, truths_are_those_in_double) {
    const double full = 2 * std::numbers::pi;
    EXPECT_DOUBLE_EQ(ri::a1(arguments_of(0, full, 0, 0, full / 4)).value[0], std::numbers::pi);
    EXPECT_DOUBLE_EQ(ri::b(arguments_of(0, full, 0, 0, full / 2, 0, 0, 1, 0, 0, 1)).value[0], 2 * full / 3);
    EXPECT_DOUBLE_EQ(ri::c5(arguments_of(0, full, 0, 0, 0, 0)).value[0], std::numbers::pi);
    // A lobe without sharpness is a constant: nothing of L_o is approximate.
    const double half = std::numbers::pi;
    EXPECT_DOUBLE_EQ(
        ri::radiance(arguments_of(0, half, 0, half / 2, half / 2, 0, 0, 1, 0.6, 0, 0.8, 0, 2, 1.8, 0))
            .value[0],
        2 * std::numbers::pi);
}

/// The sum of |moments|, no part of which cancels when a cell is cut.
double size_of(const Moments<Real>& m) {
    double sum = 0;
    for (const Real& x : m) sum += std::abs(static_cast<double>(x));
    return sum;
}

TEST(integrals, add_up_over_parts) {
    for_each_input(
        *stiffness::boundary_cells(stiffness::Trailing::nothing), 20, 4,
        [&](const Arguments& x, const std::string& from) {
            if (!stiffness::is_boundary_cell(x)) return;
            const Cell<Real> whole =
                ri::boundary_cell<Real>(x.numbers[0], x.numbers[1], x.numbers[2], x.numbers[3], x.numbers[4]);
            // At 3/10 of the width, and at a height of 2/5.
            const Real cut = whole.rise0 + (whole.rise1 - whole.rise0) * 3 / 10;
            const Moments<Real> m = ri::moments(whole);
            const Moments<Real> left = ri::moments(
                {whole.middle - whole.half * 7 / 10, whole.half * 3 / 10, whole.theta0, whole.rise0, cut});
            const Moments<Real> right = ri::moments(
                {whole.middle + whole.half * 3 / 10, whole.half * 7 / 10, whole.theta0, cut, whole.rise1});
            for (std::size_t i = 0; i < ri::moment_count; ++i)
                EXPECT_LE(std::abs(static_cast<double>(Real(left[i] + right[i] - m[i]))),
                          1e-27 * (size_of(left) + size_of(right)))
                    << from << " " << i;
        });
}

TEST(integrals, change_their_sign_when_turned_round) {
    for_each_input(*stiffness::boundary_cells(stiffness::Trailing::two_vectors), 20, 6,
                   [&](const Arguments& x, const std::string& from) {
                       if (!stiffness::is_boundary_cell(x)) return;
                       Arguments turned = x;
                       std::swap(turned.numbers[0], turned.numbers[1]);
                       EXPECT_EQ(ri::b(turned).value[0], -ri::b(x).value[0]) << from;
                       EXPECT_NEAR(ri::b(turned).conditioning[0], ri::b(x).conditioning[0],
                                   1e-6 * ri::b(x).conditioning[0])
                           << from;
                   });
}

TEST(integrals, of_radiance_do_not_depend_on_where_x_is) {
    for_each_input(*stiffness::lit_cells(), 30, 4, [&](const Arguments& x, const std::string& from) {
        // A quarter turn, exact but for φ's: x' = -y, y' = x, φ' = φ + π/2.
        const auto& n = x.numbers;
        const auto radiance_of = [](const std::array<double, 16>& numbers, const Real& phi) {
            const ri::Lobe<ri::Wide> lobe = ri::radiance_lobe(numbers);
            return ri::radiance_value(numbers,
                                      ri::moments({phi, numbers[1], numbers[2], numbers[3], numbers[4]}),
                                      lobe, ri::fit_shape(lobe.m()));
        };
        std::array<double, 16> turned = n;
        for (const std::size_t vector : {5u, 8u}) {
            turned[vector] = -n[vector + 1];
            turned[vector + 1] = n[vector];
        }
        const Real off = radiance_of(turned, Real(n[0]) + pi / 2) - radiance_of(n, n[0]);
        EXPECT_LE(std::abs(static_cast<double>(off)), 1e-25 * ri::radiance(x).scale) << from;
    });
}

// --- Fits
// ---------------------------------------------------------------------------------------------------------

TEST(fits, of_lobes_leave_what_no_other_line_leaves_less_of) {
    // ∫ (G - L - ε(u + vt))² = ∫ (G - L)² + ε² ∫ (u + vt)²: nothing of first order is left if L is the best
    // line.
    for_each_input(*stiffness::lobes(), 20, 5, [&](const Arguments& x, const std::string& from) {
        const ri::Lobe<ri::Wide> lobe = ri::exact_lobe(x.numbers.data(), false);
        if (lobe.m() == 0) return;
        const auto shape = ri::fit_shape(lobe.m());
        const ri::Wide best = ri::fit_l2(lobe.m(), shape).value;
        for (const double u : {-1.0, 0.0, 1.0})
            for (const double v : {-1.0, 1.0}) {
                auto other = shape;
                other.mean.value += ri::Wide(u) * 1e-3 * best;
                other.tilt.value += ri::Wide(v) * 1e-3 * best;
                const ri::Wide worse = ri::fit_l2(lobe.m(), other).value;
                const ri::Wide expected =
                    best * sqrt(1 + ri::Wide(1e-3) * 1e-3 * (2 * u * u + v * v * 2 / ri::Wide(3)));
                EXPECT_GT(worse, best) << from;
                EXPECT_LE(static_cast<double>(ri::Wide(abs(worse - expected) / best)), 1e-25) << from;
            }
    });
}

TEST(fits, of_lobes_err_less_in_their_mean_than_in_their_root_of_squares) {
    for_each_input(*stiffness::lobes(), 40, 4, [&](const Arguments& x, const std::string& from) {
        const double l1 = std::abs(ri::fit_l1(x).value[0]), l2 = std::abs(ri::fit_l2(x).value[0]);
        const double width = std::abs(x.numbers[0] - x.numbers[1]);
        EXPECT_LE(l1, std::sqrt(width) * l2 * (1 + 1e-12)) << from; // Cauchy and Schwarz
    });
}

TEST(fits, of_lobes_take_intervals_that_are_turned_round) {
    const Arguments x = arguments_of(1.25, 0.5, 3, 2), turned = arguments_of(0.5, 1.25, 3, 2);
    EXPECT_EQ(ri::fit_r1(x).value[0], ri::fit_r1(turned).value[0]);
    EXPECT_EQ(ri::fit_alpha(x).value[0], ri::fit_alpha(turned).value[0]);
    EXPECT_EQ(ri::fit_l1(x).value[0], ri::fit_l1(turned).value[0]);
}

TEST(fits, of_lobes_on_nothing_are_their_tangents) {
    const Arguments x = arguments_of(0.5, 0.5, 3, 2);
    const double value = 2 * std::exp(-1.5);
    EXPECT_DOUBLE_EQ(ri::fit_r0(x).value[0], value);
    EXPECT_EQ(ri::fit_r1(x).value[0], 0);
    EXPECT_DOUBLE_EQ(ri::fit_beta(x).value[0], 3 * value);
    EXPECT_DOUBLE_EQ(ri::fit_alpha(x).value[0], value - 0.5 * 3 * value);
    EXPECT_EQ(ri::fit_l2(x).value[0], 0);
    EXPECT_EQ(ri::fit_l1(x).value[0], 0);
}

} // namespace
} // namespace gnomon::testing
