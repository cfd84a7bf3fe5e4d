// The interval of x = p̂·ω over a cell: nothing of the cell lies outside, and its ends are reached.
#include "casegen/reference/integral/cell_interval.h"
#include "casegen/reference/integral/truth.h"
#include "tests/integral/inputs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon::testing {
namespace {

namespace ri = reference::integral;
using ri::Real;

/// 1 - p̂·ω in double, with the digits of small ones.
double versine_at(const Arguments& x, double across, double along) {
    const auto& n = x.numbers;
    const double phi = n[0] + n[1] * across, theta = n[2] + (n[3] - n[2]) * along;
    const double length = std::hypot(n[4], n[5], n[6]);
    const double d[3] = {std::sin(theta) * std::cos(phi) - n[4] / length,
                         std::sin(theta) * std::sin(phi) - n[5] / length, std::cos(theta) - n[6] / length};
    return (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / 2;
}

/// The least or greatest versine by looking: a grid, then finer and finer grids around its best few places.
double by_looking(const Arguments& x, bool greatest) {
    struct Place {
        double across, along, value;
    };
    const auto better = [&](const Place& a, const Place& b) {
        return greatest ? a.value > b.value : a.value < b.value;
    };
    std::vector<Place> places;
    const int steps = 48;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const double across = 2.0 * i / steps - 1, along = 1.0 * j / steps;
            places.push_back({across, along, versine_at(x, across, along)});
        }
    std::sort(places.begin(), places.end(), better);
    places.resize(8);
    Place best = places.front();
    for (Place at : places) {
        double reach = 2.0 / steps;
        for (int round = 0; round < 100; ++round, reach *= 0.75)
            for (int i = -2; i <= 2; ++i)
                for (int j = -2; j <= 2; ++j) {
                    const double across = std::clamp(at.across + reach * i / 2, -1.0, 1.0);
                    const double along = std::clamp(at.along + reach * j / 4, 0.0, 1.0);
                    const Place next{across, along, versine_at(x, across, along)};
                    if (better(next, at)) at = next;
                }
        if (better(at, best)) best = at;
    }
    return best.value;
}

TEST(interval, is_what_looking_everywhere_finds) {
    int inputs = 0;
    for_each_input(*stiffness::cells_and_axes(), 60, 2, [&](const Arguments& x, const std::string& from) {
        const Truth truth = ri::interval_versines(x);
        const double most = by_looking(x, true), least = by_looking(x, false);
        // What doubles know of a versine: 1e-16 of the axis, twice.
        const auto known = [](double versine) { return 4e-16 * std::sqrt(versine) + 1e-31; };
        EXPECT_LE(most, truth.value[0] + known(most) + 4e-16) << from;
        EXPECT_GE(most, truth.value[0] * (1 - 1e-9) - known(most)) << from;
        EXPECT_GE(least, truth.value[1] - known(least)) << from;
        EXPECT_LE(least, truth.value[1] * (1 + 1e-6) + 2 * known(least) + 1e-12) << from;
        ++inputs;
    });
    EXPECT_GT(inputs, 100);
}

TEST(interval, is_one_less_its_versines) {
    for_each_input(*stiffness::cells_and_axes(), 30, 4, [&](const Arguments& x, const std::string& from) {
        const Truth ends = ri::interval(x), versines = ri::interval_versines(x);
        for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(ends.value[i], 1 - versines.value[i], 3e-16) << from;
        EXPECT_LE(ends.value[0], ends.value[1]) << from;
        EXPECT_EQ(ends.scale, 1);
        EXPECT_EQ(versines.scale, std::min(versines.value[0], versines.value[1])) << from;
    });
}

TEST(interval, keeps_the_digits_of_a_versine_just_outside) {
    // The axis d beyond the edge φ = 0.5 of a cell round the equator: 1 - cos d.
    for (int step = 1; step < locus_distances; ++step) {
        const double d = locus_distance(step);
        const std::array<Real, 7> x{0, 0.5, 1, 2, cos(Real(0.5) + d), sin(Real(0.5) + d), 0};
        const Real want = 2 * sin(Real(d) / 2) * sin(Real(d) / 2);
        EXPECT_LE(static_cast<double>(Real(abs(ri::interval_over(x).greatest.versine / want - 1))), 1e-25)
            << d;
        const std::array<Real, 7> inside{0, 0.5, 1, 2, cos(Real(0.5) - d), sin(Real(0.5) - d), 0};
        EXPECT_LE(static_cast<double>(ri::interval_over(inside).greatest.versine), 1e-100) << d;
    }
}

TEST(interval, knows_the_axis_and_its_opposite_on_any_turn) {
    const double turn = 2 * 3.14159265358979323846;
    for (const int turns : {-1000, -1, 0, 1, 1000}) {
        const Truth truth = ri::interval(arguments_of(0.25 + turn * turns, 0.5, 1, 2, 1, 0, 0));
        EXPECT_NEAR(truth.value[1], 1, 1e-15);
        const Truth opposite = ri::interval(arguments_of(0.25 + turn * turns, 0.5, 1, 2, -3, 0, 0));
        EXPECT_NEAR(opposite.value[0], -1, 1e-15);
    }
    const Truth everything = ri::interval(arguments_of(0, turn / 2, 0, turn / 2, 1, 2, 3));
    EXPECT_NEAR(everything.value[0], -1, 1e-15);
    EXPECT_NEAR(everything.value[1], 1, 1e-15);
    EXPECT_TRUE(std::isnan(ri::interval(arguments_of(0, 1, 0, 1, 0, 0, 0)).value[0])); // no axis
}

TEST(interval, is_conditioned_as_differences_say) {
    Random random(7);
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        Arguments x{};
        stiffness::cells_and_axes()->draw(random, x.numbers);
        round_to_float(x);
        const Truth truth = ri::interval(x);
        for (std::size_t end = 0; end < 2; ++end) {
            double wanted = 0, kink = 0;
            for (std::size_t k = 0; k < 7; ++k) {
                const double step = 1e-6;
                Arguments more = x, less = x;
                more.numbers[k] += step;
                less.numbers[k] -= step;
                const double up = ri::interval(more).value[end] - truth.value[end];
                const double down = truth.value[end] - ri::interval(less).value[end];
                wanted += std::abs(x.numbers[k]) * std::max(std::abs(up), std::abs(down)) / step * 0x1p-24;
                kink += std::abs(x.numbers[k] * (up - down)) / step * 0x1p-24;
            }
            if (kink > 1e-3 * wanted + 1e-12) continue; // two places share the end, or nearly
            EXPECT_NEAR(truth.conditioning[end], wanted, 1e-3 * wanted + 1e-12) << i << " " << end;
            ++compared;
        }
    }
    EXPECT_GT(compared, 80);
}

} // namespace
} // namespace gnomon::testing
