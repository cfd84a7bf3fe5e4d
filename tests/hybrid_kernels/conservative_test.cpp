// What makes grown and shrunken triangles and their depths conservative, on the device's own results.
#include "tests/hybrid_kernels/region.h"

#include <fmt/format.h>

namespace gnomon {
namespace {

using namespace testing;
namespace truth = hybrid_truth;

/// The corners of the texel square around p whose half diagonal is lambda.
std::array<Point, 4> texel_around(const Point& p, double lambda) {
    const double half = lambda * std::sqrt(0.5);
    return {Point{p.x - half, p.y - half},
            {p.x + half, p.y - half},
            {p.x - half, p.y + half},
            {p.x + half, p.y + half}};
}
std::vector<Numbered> rows_of(const std::vector<Trial>& all) {
    std::vector<Numbered> rows;
    for (const Trial& trial : all) rows.push_back(trial.numbers());
    return rows;
}

TEST(dilated, holds_every_texel_square_that_the_triangle_touches) {
    const std::vector<Trial> all = trials(94, 4000);
    const auto grown = emitted("conservative/dilated", rows_of(all), 1);
    const std::vector<double> boxes = run_floats("conservative/clip_box", rows_of(all));
    std::size_t lines = 0, points = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Trial& trial = all[i];
        const Corners& triangle = grown[i][0];
        // The hull of these twelve is the triangle's Minkowski sum with the square. Against a line's stand-in
        // nothing is divided by a sine.
        const bool is_line = trial.sine() < truth::parallel;
        const double rounding = is_line ? 0x1p-20 * trial.magnitude() : trial.rounding();
        for (const Point& corner : trial.corners)
            for (const Point& p : texel_around(corner, trial.lambda)) {
                if (truth::is_clear(trial.sine()) && truth::least_sine(triangle) > 0)
                    ASSERT_GE(inside(triangle, p), -2 * rounding)
                        << "trial " << i << ", sine " << trial.sine();
                const double slack = 0x1p-22 * trial.magnitude();
                ASSERT_TRUE(p.x >= boxes[4 * i] - slack && p.y >= boxes[4 * i + 1] - slack &&
                            p.x <= boxes[4 * i + 2] + slack && p.y <= boxes[4 * i + 3] + slack);
            }
        lines += is_line ? 1u : 0u;
        points += truth::least_sine(triangle) > 0 ? 0u : 1u;
    }
    EXPECT_GT(lines, 50u);
    EXPECT_LT(points, 40u) << "what has no extent cannot be asked";
}

TEST(dilated, a_line_or_a_point_becomes_a_triangle_around_it) {
    for (const Trial& trial : {Trial{{Point{0.25, 0.5}, {0.25, 0.5}, {0.25, 0.5}}, 0.125},
                               Trial{{Point{0, 0}, {0.5, 0.5}, {0.25, 0.25}}, 0.0625},
                               Trial{{Point{-0.5, 0.25}, {-0.5, 0.25}, {0.75, 0.25}}, 0.0625}}) {
        const Corners triangle = emitted("conservative/dilated", {trial.numbers()}, 1)[0][0];
        for (const Point& corner : trial.corners)
            for (const Point& p : texel_around(corner, trial.lambda)) EXPECT_GT(inside(triangle, p), -1e-6);
        EXPECT_GT(truth::least_sine(triangle), 0.01);
    }
}

TEST(eroded, a_texel_square_centred_in_it_lies_within_the_triangle) {
    const std::vector<Trial> all = trials(95, 4000);
    const auto shrunk = emitted("conservative/eroded", rows_of(all), 1);
    const std::vector<std::uint32_t> erodes = run_numbers("conservative/erodes", rows_of(all)),
                                     published =
                                         run_numbers("conservative/erodes_as_published", rows_of(all));
    std::size_t left = 0, dropped = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (published[i] != 0) EXPECT_NE(erodes[i], 0u) << "what is published keeps less";
        if (erodes[i] == 0) {
            ++dropped;
            continue;
        }
        ++left;
        for (const Point& corner : shrunk[i][0])
            for (const Point& p : texel_around(corner, all[i].lambda))
                ASSERT_GE(inside(all[i].corners, p), -2 * all[i].rounding()) << "trial " << i;
    }
    EXPECT_GT(left, 1000u);
    EXPECT_GT(dropped, 500u);
}

TEST(tight_offset, lets_the_texel_s_corners_pass_and_is_never_more_than_half_its_diagonal) {
    std::vector<Numbered> rows;
    Random random(96);
    for (int i = 0; i < 2000; ++i) {
        const double angle = 6.2831853 * random.unit();
        const auto f = [](double x) { return static_cast<double>(static_cast<float>(x)); };
        rows.push_back({f(std::cos(angle)), f(std::sin(angle)), f(random.unit()), f(random.unit())});
    }
    const std::vector<double> offsets = run_floats("conservative/tight_offset", rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        double farthest = 0;
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
                farthest = std::max(farthest, rows[i][0] * x * rows[i][2] + rows[i][1] * y * rows[i][3]);
        EXPECT_NEAR(offsets[i], farthest, 0x1p-23);
        EXPECT_LE(offsets[i], 0.5 * std::hypot(rows[i][2], rows[i][3]) * (1 + 0x1p-22));
    }
}

/// Rows for depth_bounds as its generator draws them, ordinary and near every locus.
std::vector<Numbered> depth_rows(std::size_t count) {
    const Case& c = find_case("conservative/depth_bounds");
    std::vector<Numbered> rows;
    std::vector<std::uint32_t> words(word_count(c));
    for (std::size_t i = 0; i < count; ++i) {
        Random random(97, i);
        std::optional<Place> place;
        if (i % 3 == 0)
            place = Place{random.below(static_cast<std::uint32_t>(c.generator->loci.size())),
                          random.between(0, locus_distances - 1)};
        draw_generated(c, random, place, words);
        Numbered row;
        for (const std::uint32_t word : words) row.push_back(widen(Scalar::float32, word));
        rows.push_back(row);
    }
    return rows;
}

TEST(depth_bounds, hold_the_plane_s_depths_over_the_texel_whatever_is_rounded) {
    const std::vector<Numbered> rows = depth_rows(6000);
    const std::vector<double> bounds = run_floats("conservative/depth_bounds", rows);
    std::size_t inner = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Numbered& n = rows[i];
        const Corners corners{Point{n[0], n[1]}, {n[3], n[4]}, {n[6], n[7]}};
        const double least = std::min({n[2], n[5], n[8]}), most = std::max({n[2], n[5], n[8]});
        const double nearest = bounds[2 * i], farthest = bounds[2 * i + 1];
        ASSERT_LE(nearest, farthest);
        ASSERT_GE(nearest, least);
        ASSERT_LE(farthest, most);
        if (truth::least_sine(corners) < truth::parallel / 2) {
            ASSERT_EQ(nearest, least);
            ASSERT_EQ(farthest, most);
            continue;
        }
        if (truth::least_sine(corners) < 2 * truth::parallel) continue;
        // By barycentric weights in 57 digits, at the texel's four corners; no tolerance.
        const auto exact = as<Real>(corners);
        const Real area = truth::area2(exact[0], exact[1], exact[2]);
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0}) {
                const truth::Point<Real> p{Real(n[9]) + x * Real(n[11]), Real(n[10]) + y * Real(n[12])};
                const Real depth =
                    (truth::area2(p, exact[1], exact[2]) * n[2] + truth::area2(exact[0], p, exact[2]) * n[5] +
                     truth::area2(exact[0], exact[1], p) * n[8]) /
                    area;
                // Beyond the triangle's own range nothing of it is left to bound.
                const double clamped = std::clamp(static_cast<double>(depth), least, most);
                ASSERT_LE(nearest, clamped) << "row " << i;
                ASSERT_GE(farthest, clamped) << "row " << i;
            }
        inner += nearest > least || farthest < most ? 1u : 0u;
    }
    EXPECT_GT(inner, 1000u) << "bounds that are always the whole range bound nothing";
}

TEST(hostile_triangles, get_finite_answers) {
    const float inf = INFINITY, largest = 3.4028235e38f;
    const std::vector<double> odd{0, 1, -1, 1e6, 1e-6, 1e-38, largest, -largest, inf, -inf, NAN};
    std::vector<Trial> all;
    Random random(98);
    for (int i = 0; i < 3000; ++i) {
        const auto pick = [&] { return odd[random.below(static_cast<std::uint32_t>(odd.size()))]; };
        Trial trial;
        for (Point& p : trial.corners) p.x = pick(), p.y = pick();
        trial.lambda = pick();
        all.push_back(trial);
    }
    for (const char* kernel :
         {"conservative/dilated", "conservative/eroded", "adjacency/shadowed_0", "adjacency/shadowed_3"})
        for (const auto& triangles : emitted(kernel, rows_of(all), 4))
            for (const Corners& each : triangles)
                for (const Point& p : each) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << kernel;
}

} // namespace
} // namespace gnomon
