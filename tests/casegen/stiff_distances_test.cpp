// Every locus's inputs lie as far from it as they are asked to, and on it where they are asked to be on it.
// (In doubles: rounding them to float moves them by what a float can say.)
#include "casegen/stiffness.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gnomon::stiffness {
namespace {

constexpr double pi = std::numbers::pi;
using Drawn = std::array<double, 16>;

/// How far from the locus an input is.
using Distance = std::function<double(const Drawn&)>;

/// `visit(numbers, distance, where)` on several inputs at every distance.
void for_each_placed(const Generator& generator, const std::string& name,
                     const std::function<void(const Drawn&, double, const std::string&)>& visit) {
    const auto locus = std::ranges::find(generator.loci, name, &Locus::name);
    ASSERT_NE(locus, generator.loci.end()) << generator.name << " has no locus " << name;
    for (int step = 0; step < locus_distances; ++step)
        for (std::uint64_t i = 0; i < 40; ++i) {
            Random random(i, static_cast<std::uint64_t>(step));
            Drawn numbers{};
            generator.draw(random, numbers);
            locus->place(random, locus_distance(step), numbers);
            visit(numbers, locus_distance(step), generator.name + ", " + name);
        }
}

/// No input is farther than asked, by more than doubles' rounding; and some are about that far, so that no
/// distance is left out.
void expect_within(const Generator& generator, const std::string& name, const Distance& distance,
                   double times = 1, double rounding = 1e-12) {
    double farthest = 0, asked = 0;
    for_each_placed(generator, name, [&](const Drawn& n, double d, const std::string& where) {
        EXPECT_LE(distance(n), times * d * (1 + 1e-6) + rounding) << where << " at " << d;
        if (d != 1e-4) return;
        asked = d;
        farthest = std::max(farthest, distance(n));
    });
    EXPECT_GT(farthest, 0.25 * asked) << generator.name << ", " << name << ": all of them too near";
}

/// What grows beyond all bounds reaches 1/d, up to a limit.
void expect_beyond(const Generator& generator, const std::string& name, const Distance& size, double most,
                   double times = 1) {
    for_each_placed(generator, name, [&](const Drawn& n, double d, const std::string& where) {
        EXPECT_GE(size(n), times * (d > 0 ? std::min(1 / d, most) : most) * (1 - 1e-6))
            << where << " at " << d;
    });
}

double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }

// --- Cells under a boundary

double height(const Drawn& n, std::size_t end) { return n[3] * as_float(n[end]) + n[4]; }
double width(const Drawn& n) { return std::abs(n[1] - n[0]); }
double farther(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

TEST(boundary_cells, slopes_are_as_near_to_k_as_they_should_be) {
    const auto generator = boundary_cells(Trailing::nothing);
    const std::pair<const char*, double> slopes[] = {
        {"k = 0", 0},           {"k = 1/3", 1.0 / 3},   {"k = 1/2", 0.5},      {"k = 2/3", 2.0 / 3},
        {"k = 1", 1},           {"k = 2", 2},           {"k = -1", -1},        {"k = -2", -2},
        {"k = -1/3", -1.0 / 3}, {"k = -1/2", -1.0 / 2}, {"k = -2/3", -2.0 / 3}};
    for (const auto& [name, k] : slopes) {
        expect_within(
            *generator, name, [k = k](const Drawn& n) { return std::abs(n[3] - k); }, 1, 2e-7);
        for_each_placed(*generator, name, [k = k](const Drawn& n, double d, const std::string& where) {
            if (d == 0) EXPECT_EQ(n[3], as_float(k)) << where;
            EXPECT_GE(std::min(height(n, 0), height(n, 1)), -1e-5) << where;
            EXPECT_LE(std::max(height(n, 0), height(n, 1)), pi + 1e-5) << where;
        });
    }
}

TEST(boundary_cells, narrow_and_full_ones_are_as_wide_as_they_should_be) {
    const auto generator = boundary_cells(Trailing::angle);
    expect_within(*generator, "phi1 - phi0 = 0", width);
    expect_within(*generator, "phi1 - phi0 = 2 pi", [](const Drawn& n) { return 2 * pi - width(n); });
    for_each_placed(*generator, "phi1 - phi0 = 0", [](const Drawn& n, double d, const std::string&) {
        if (d == 0) EXPECT_EQ(n[0], n[1]);
    });
}

TEST(boundary_cells, slabs_are_as_thin_as_they_should_be) {
    const auto generator = boundary_cells(Trailing::nothing);
    expect_within(*generator, "theta = theta0",
                  [](const Drawn& n) { return farther(height(n, 0) - n[2], height(n, 1) - n[2]); });
    expect_within(*generator, "theta = theta0 at one end",
                  [](const Drawn& n) { return std::abs(height(n, 0) - n[2]); });
}

TEST(boundary_cells, polar_ones_are_as_near_to_either_pole_as_they_should_be) {
    const auto generator = boundary_cells(Trailing::nothing);
    expect_within(*generator, "theta = 0", [](const Drawn& n) { return n[2]; });
    expect_within(*generator, "theta = pi", [](const Drawn& n) { return pi - n[2]; });
    for (const auto& [name, pole] : {std::pair{"theta = 0", 0.0}, std::pair{"theta = pi", pi}})
        for_each_placed(*generator, name, [pole = pole](const Drawn& n, double d, const std::string& where) {
            if (d == 0)
                EXPECT_EQ(n[2], pole) << where;
            else
                EXPECT_LE(farther(height(n, 0) - pole, height(n, 1) - pole), d * (1 + 1e-6) + 1e-12) << where;
        });
}

TEST(boundary_cells, steep_and_offset_ones_are_as_steep_and_far_as_they_should_be) {
    const auto generator = boundary_cells(Trailing::nothing);
    expect_beyond(
        *generator, "1/k = 0", [](const Drawn& n) { return std::abs(n[3]); }, 1e7);
    for_each_placed(*generator, "1/k = 0", [](const Drawn& n, double, const std::string& where) {
        EXPECT_LE(std::abs(n[3]) * width(n), pi * (1 + 1e-6)) << where;
    });
    expect_beyond(
        *generator, "1/phi = 0", [](const Drawn& n) { return std::abs(n[0]) / (2 * pi) + 1.5; }, 1000);
}

TEST(boundary_cells, negative_heights_are_as_far_below_as_they_should_be) {
    const auto generator = boundary_cells(Trailing::nothing);
    for_each_placed(
        *generator, "boundary below theta0", [](const Drawn& n, double d, const std::string& where) {
            EXPECT_LE(std::max(height(n, 0), height(n, 1)), n[2] - std::min(d, 0.5) + 1e-6) << where;
            EXPECT_GE(std::min(height(n, 0), height(n, 1)), -1e-6) << where;
        });
}

TEST(boundary_cells, vectors_are_as_near_to_the_pole_as_they_should_be) {
    const auto generator = boundary_cells(Trailing::two_vectors);
    expect_within(
        *generator, "n on the pole", [](const Drawn& n) { return std::hypot(n[5], n[6]); }, std::sqrt(2));
    expect_within(
        *generator, "p on the pole", [](const Drawn& n) { return std::hypot(n[8], n[9]); }, std::sqrt(2));
}

// --- Waves

TEST(waves, frequencies_are_as_near_as_they_should_be) {
    const auto generator = waves(1, true); // phi0, phi1, p, s, t
    for (const auto& [name, s] : {std::pair{"s = 0", 0.0}, std::pair{"s = 1", 1.0}, std::pair{"s = -1", -1.0},
                                  std::pair{"s = 2", 2.0}, std::pair{"s = -2", -2.0}}) {
        expect_within(*generator, name, [s = s](const Drawn& n) { return std::abs(n[3] - s); });
        for_each_placed(*generator, name, [s = s](const Drawn& n, double d, const std::string& where) {
            if (d == 0) EXPECT_EQ(n[3], s) << where;
        });
    }
    expect_beyond(
        *generator, "1/s = 0", [](const Drawn& n) { return std::abs(n[3]); }, 1e4);
    expect_beyond(
        *generator, "1/phi = 0", [](const Drawn& n) { return std::abs(n[0]) / (2 * pi) + 1.5; },
        30); // turns: a second wave of frequency 30 is known no further
    expect_within(*generator, "phi1 - phi0 = 0", width);
    expect_within(*generator, "phi1 - phi0 = 2 pi",
                  [](const Drawn& n) { return std::abs(2 * pi - width(n)); });
}

// --- Lobes

TEST(lobes, are_as_flat_and_as_sharp_as_they_should_be) {
    const auto generator = lobes();
    const Distance m = [](const Drawn& n) { return 0.5 * n[2] * std::abs(n[0] - n[1]); };
    expect_within(*generator, "lambda q = 0", m);
    expect_within(*generator, "width = 0", [](const Drawn& n) { return std::abs(n[0] - n[1]); });
    expect_beyond(*generator, "1 / lambda q = 0", m, 1e6, 0.5);
    expect_within(*generator, "lambda q = 1", [&](const Drawn& n) { return std::abs(m(n) - 1); });
    expect_within(*generator, "lambda q = 3", [&](const Drawn& n) { return std::abs(m(n) - 3); });
    expect_within(
        *generator, "lambda q = 88", [&](const Drawn& n) { return std::abs(m(n) - 88); }, 10, 1e-11);
    expect_within(*generator, "peak", [](const Drawn& n) { return n[1]; });
    expect_within(*generator, "mu = 0", [](const Drawn& n) { return std::abs(n[3]); });
    expect_within(*generator, "the whole sphere", [](const Drawn& n) { return farther(2 - n[0], n[1]); });
}

TEST(lobes, intervals_that_end_before_they_begin_do_so) {
    int reversed = 0;
    for_each_placed(*lobes(), "a = b", [&](const Drawn& n, double d, const std::string& where) {
        EXPECT_LE(n[0], n[1]) << where;
        EXPECT_LE(n[1] - n[0], d) << where;
        reversed += n[0] < n[1] ? 1 : 0;
    });
    EXPECT_GT(reversed, 100);
}

TEST(lobes, by_their_ends_are_those_by_their_versines) {
    const auto by_versines = lobes(), by_ends = lobes_of_ends();
    ASSERT_EQ(by_versines->loci.size(), by_ends->loci.size());
    for (std::uint64_t i = 0; i < 50; ++i) {
        Random one(i), other(i);
        Drawn versines{}, ends{};
        by_versines->draw(one, versines);
        by_ends->draw(other, ends);
        EXPECT_EQ(ends[0], 1 - versines[0]);
        EXPECT_EQ(ends[1], 1 - versines[1]);
        EXPECT_EQ(ends[2], versines[2]);
        EXPECT_EQ(ends[3], versines[3]);
    }
}

// --- Axes, of cells (phi, half, theta (2), p) and of lit cells (phi, half, theta0, rise (2), n, p, …)

struct Cell {
    double phi, half, low, high;
    glm::dvec3 p;
};
Cell cell_of(const Drawn& n, bool is_lit) {
    if (!is_lit) return {n[0], n[1], n[2], n[3], {n[4], n[5], n[6]}};
    const double first = n[2] + n[3], last = n[2] + n[4];
    return {n[0], n[1], std::min({n[2], first, last}), std::max({n[2], first, last}), {n[8], n[9], n[10]}};
}
glm::dvec3 direction(double phi, double theta) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
/// The chord between the axis and the meridian at this azimuth (both halves of it).
double off_meridian(const Cell& cell, double phi) {
    return std::abs(cell.p.y * std::cos(phi) - cell.p.x * std::sin(phi));
}

TEST(axes, are_as_near_to_each_part_of_a_cell_as_they_should_be) {
    for (const bool is_lit : {false, true}) {
        const auto generator = is_lit ? lit_cells() : cells_and_axes();
        const auto within = [&](const std::string& name, const std::function<double(const Cell&)>& distance,
                                double times = 1) {
            expect_within(
                *generator, name, [&](const Drawn& n) { return distance(cell_of(n, is_lit)); }, times, 1e-11);
        };
        // As wide as a cell may be: half a turn, and 0 … π.
        within(
            "axis inside",
            [](const Cell& c) { return glm::length(c.p - direction(c.phi, 0.5 * (c.low + c.high))); },
            1.5 * pi);
        within(
            "axis opposite",
            [](const Cell& c) { return glm::length(c.p + direction(c.phi, 0.5 * (c.low + c.high))); },
            1.5 * pi);
        within(
            "axis on a theta edge",
            [](const Cell& c) { return std::abs(std::acos(std::clamp(c.p.z, -1.0, 1.0)) - c.low); },
            1 + 1e-3);
        within("axis on a phi edge", [](const Cell& c) { return off_meridian(c, c.phi + c.half); });
        within(
            "axis on a corner",
            [](const Cell& c) { return glm::length(c.p - direction(c.phi - c.half, c.high)); }, std::sqrt(2));
        within("axis on the pole", [](const Cell& c) { return std::hypot(c.p.x, c.p.y); });
        within("axis on the equator", [](const Cell& c) { return std::abs(c.p.z); });
    }
}

TEST(axes, of_lit_cells_have_length_1_and_of_cells_alone_any_that_is_in_their_domain) {
    for (const bool is_lit : {false, true}) {
        const auto generator = is_lit ? lit_cells() : cells_and_axes();
        for (const Locus& locus : generator->loci)
            for_each_placed(*generator, locus.name, [&](const Drawn& n, double, const std::string& where) {
                const double length = glm::length(cell_of(n, is_lit).p);
                if (is_lit)
                    EXPECT_NEAR(length, 1, 1e-9) << where;
                else
                    EXPECT_TRUE(length > (locus.name == "length = 0" ? 1e-30 : 0.009) && length < 1 + 1e-9)
                        << where << ": " << length;
            });
    }
}

TEST(lit_cells, are_as_small_thin_polar_and_steep_as_they_should_be) {
    const auto generator = lit_cells();
    const Distance half = [](const Drawn& n) { return std::abs(n[1]); };
    const Distance rise = [](const Drawn& n) { return farther(n[3], n[4]); };
    expect_within(*generator, "size = 0", [&](const Drawn& n) { return std::max(half(n), rise(n)); });
    expect_within(*generator, "half_width = 0", half);
    expect_within(*generator, "half_width = pi", [&](const Drawn& n) { return pi - half(n); });
    expect_within(*generator, "rise = 0", rise);
    expect_within(*generator, "theta = 0", [](const Drawn& n) { return n[2]; });
    expect_within(*generator, "theta = pi", [](const Drawn& n) { return pi - n[2]; });
    expect_within(*generator, "mu = 0", [](const Drawn& n) { return std::abs(n[12]); });
    expect_within(*generator, "normal on the pole", [](const Drawn& n) { return std::hypot(n[5], n[6]); });
    expect_beyond(
        *generator, "1 / boundary's slope = 0", [&](const Drawn& n) { return 1 / half(n); }, 1e7);
    expect_beyond(
        *generator, "1/phi = 0", [](const Drawn& n) { return std::abs(n[0]) / (2 * pi) + 1.5; }, 1000);
    for_each_placed(*generator, "boundary below theta0",
                    [&](const Drawn& n, double d, const std::string& where) {
                        EXPECT_LE(std::max(n[3], n[4]), -std::min(d, 0.5) + 1e-12) << where;
                    });
}

TEST(lit_cells, have_lobes_as_flat_and_as_sharp_as_they_should_be) {
    const auto generator = lit_cells();
    const Distance m = [](const Drawn& n) { return 0.5 * n[11] * std::abs(n[13] - n[14]); };
    expect_within(*generator, "lambda q = 0", m);
    int sharp = 0, placed = 0;
    for_each_placed(*generator, "1 / lambda q = 0", [&](const Drawn& n, double d, const std::string&) {
        ++placed;
        sharp += m(n) >= 0.5 * (d > 0 ? std::min(1 / d, 1e6) : 1e6) * (1 - 1e-6) ? 1 : 0;
    });
    EXPECT_GT(sharp, 8 * placed / 10); // not where that would take a sharper lobe than there may be
}

} // namespace
} // namespace gnomon::stiffness
