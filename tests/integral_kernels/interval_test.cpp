// The interval of a dot product over a cell: exactly, and by the four corners as printed.
#include "tests/integral_kernels/rows.h"

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <numbers>

namespace gnomon {
namespace {

using testing::Row;
using testing::run_rows;

constexpr double pi = std::numbers::pi;
constexpr double cell_size = pi / 8; // 22.5°, sixteen of them round the equator

glm::dvec3 direction(double phi, double theta) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
Row row_of(double phi, double half, double theta0, double theta1, glm::dvec3 p) {
    return {static_cast<float>(phi),    static_cast<float>(half), static_cast<float>(theta0),
            static_cast<float>(theta1), static_cast<float>(p.x),  static_cast<float>(p.y),
            static_cast<float>(p.z)};
}

/// A cell of the grid of 16 by 8, and an axis: anywhere, or within a cell's size of its middle.
Row cell_of_grid(Random& random, bool near) {
    const double phi = cell_size * (random.below(16) + 0.5), theta0 = cell_size * random.below(8);
    const auto within = [&](double reach) { return reach * (2 * random.unit() - 1); };
    const double z = within(1), azimuth = within(pi);
    const glm::dvec3 anywhere = direction(azimuth, std::acos(z));
    const glm::dvec3 close = direction(phi + within(cell_size), theta0 + cell_size * (0.5 + within(1)));
    return row_of(phi, 0.5 * cell_size, theta0, theta0 + cell_size, near ? close : anywhere);
}
std::vector<Row> cells_of_grid(std::size_t count, bool near) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < count; ++i) {
        Random random(near ? 31 : 30, i);
        rows.push_back(cell_of_grid(random, near));
    }
    return rows;
}

struct Ends {
    double a, b;
};
std::vector<Ends> run_interval(const char* form, const std::vector<Row>& rows) {
    const std::vector<float> words = run_rows(fmt::format("integral/interval/{}", form), rows);
    std::vector<Ends> ends;
    for (std::size_t i = 0; i < rows.size(); ++i)
        ends.push_back({static_cast<double>(words[2 * i]), static_cast<double>(words[2 * i + 1])});
    return ends;
}

TEST(intervals, the_exact_one_holds_that_of_the_corners) {
    std::vector<Row> rows = cells_of_grid(4000, false);
    for (const Row& row : cells_of_grid(4000, true)) rows.push_back(row);
    for (const Row& row : testing::ordinary_rows(find_case("integral/interval/exact"), 4000, 32))
        rows.push_back(row);
    const std::vector<Ends> exact = run_interval("exact", rows), corner = run_interval("corner", rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_LE(exact[i].a, corner[i].a + 1e-6) << i;
        EXPECT_GE(exact[i].b, corner[i].b - 1e-6) << i;
    }
}

TEST(intervals, the_exact_one_holds_every_point_of_the_cell) {
    const std::vector<Row> rows = testing::ordinary_rows(find_case("integral/interval/exact"), 2000, 33);
    const std::vector<Ends> exact = run_interval("exact", rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Random random(34, i);
        const auto number = [&](std::size_t k) { return static_cast<double>(rows[i][k]); };
        const glm::dvec3 p = glm::normalize(glm::dvec3(number(4), number(5), number(6)));
        for (int sample = 0; sample < 20; ++sample) {
            const double dot = glm::dot(p, direction(number(0) + number(1) * (2 * random.unit() - 1),
                                                     number(2) + (number(3) - number(2)) * random.unit()));
            ASSERT_TRUE(dot >= exact[i].a - 1e-6 && dot <= exact[i].b + 1e-6) << i << ": " << dot;
        }
    }
}

TEST(intervals, versines_are_those_of_the_exact_one) {
    const std::vector<Row> rows = testing::ordinary_rows(find_case("integral/interval/exact"), 4000, 35);
    const std::vector<Ends> exact = run_interval("exact", rows), versines = run_interval("versines", rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(1 - exact[i].a, versines[i].a, 1e-6) << i;
        EXPECT_NEAR(1 - exact[i].b, versines[i].b, 1e-6) << i;
        EXPECT_GE(versines[i].a, versines[i].b) << i;
    }
}

/// On how many of the grid's cells corners are wrong by more than rounding, and by how much at most.
struct Wrong {
    double share = 0, most = 0; ///< in units of the half width of the interval
};
Wrong corners_are_wrong(bool near) {
    const std::vector<Row> rows = cells_of_grid(20000, near);
    const std::vector<Ends> exact = run_interval("exact", rows), corner = run_interval("corner", rows);
    Wrong wrong;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double off = std::max(corner[i].a - exact[i].a, exact[i].b - corner[i].b);
        if (off < 1e-5) continue;
        wrong.share += 1.0 / static_cast<double>(rows.size());
        wrong.most = std::max(wrong.most, off / (0.5 * (exact[i].b - exact[i].a)));
    }
    return wrong;
}

TEST(intervals, corners_are_no_bound_on_a_quarter_of_all_cells_and_half_of_those_near_the_axis) {
    const Wrong anywhere = corners_are_wrong(false), near = corners_are_wrong(true);
    RecordProperty("anywhere",
                   fmt::format("{:.3f} of the cells, by up to {:.2f} q", anywhere.share, anywhere.most));
    RecordProperty("near", fmt::format("{:.3f} of the cells, by up to {:.2f} q", near.share, near.most));
    EXPECT_GT(anywhere.share, 0.19);
    EXPECT_LT(anywhere.share, 0.27);
    EXPECT_GT(near.share, 0.42);
    EXPECT_LT(near.share, 0.52);
    EXPECT_GT(near.most, 0.5);
}

/// The upper ends while the axis walks across a φ edge of the cell φ = -0.2 … 0.2, θ = 1 … 1.4.
std::vector<Ends> walk(const char* form) {
    std::vector<Row> rows;
    for (int step = -2000; step <= 2000; ++step)
        rows.push_back(row_of(0, 0.2, 1, 1.4, direction(0.2 + 1e-5 * step, 1.2)));
    return run_interval(form, rows);
}
double greatest_step(const std::vector<Ends>& ends) {
    double greatest = 0;
    for (std::size_t i = 1; i < ends.size(); ++i)
        greatest =
            std::max({greatest, std::abs(ends[i].a - ends[i - 1].a), std::abs(ends[i].b - ends[i - 1].b)});
    return greatest;
}

TEST(intervals, the_exact_one_is_continuous_where_the_axis_crosses_an_edge_and_corners_jump) {
    EXPECT_LE(greatest_step(walk("exact")), 1.2e-5); // the axis's own step, and a rounding
    EXPECT_LE(greatest_step(walk("versines")), 1.2e-5);
    EXPECT_GE(greatest_step(walk("corner")), 1e-2);
}

} // namespace
} // namespace gnomon
