// The corners that the adjacency kernels are judged by, against a triangle from which every half-plane is cut
// one after the other.
#include "casegen/reference/hybrid/remains.h"
#include "tests/hybrid_kernels/region.h"

#include <fmt/format.h>

#include <map>

namespace gnomon {
namespace {

using namespace testing;
namespace truth = hybrid_truth;

std::vector<Trial> some_trials(std::size_t count) {
    return trials(94, count, hybrid::shrunken_triangles("trials", {.distance = 6}));
}

Polygon<Real> polygon_of(const Trial& trial, unsigned away, const truth::Remains& remains) {
    const auto corners = as<Real>(trial.corners);
    Polygon<Real> polygon;
    for (const truth::RemainsCorner& corner : remains.corners)
        polygon.push_back(
            truth::meet(truth::remains_line<Real>(corners, Real(trial.lambda), away, corner.before),
                        truth::remains_line<Real>(corners, Real(trial.lambda), away, corner.behind)));
    return polygon;
}

/// Every way to ask: which edges stay, which of the corners between them are cut.
template <typename Use>
void for_all_ways(const Use& use) {
    for (unsigned away = 0; away < 8; ++away)
        for (unsigned cut = 0; cut < 8; ++cut)
            if ((cut & ~truth::between(away)) == 0) use(away, cut);
}

TEST(remains, are_what_the_half_planes_leave) {
    for_all_ways([](unsigned away, unsigned cut) {
        SCOPED_TRACE(fmt::format("away {}, cut {}", away, cut));
        std::size_t clear = 0, empty = 0, all = 0;
        std::map<std::size_t, std::size_t> of_size;
        for (const Trial& trial : some_trials(400)) {
            if (!truth::is_broad(trial.sine())) continue;
            ++all;
            const truth::Remains remains = truth::remains(trial.corners, trial.lambda, away, cut);
            if (!remains.is_clear) continue;
            ++clear;
            empty += remains.corners.empty() ? 1u : 0u;
            ++of_size[remains.corners.size()];
            const std::vector<HalfPlane> planes = half_planes(trial, away, cut);
            const Polygon<Real> polygon = polygon_of(trial, away, remains);
            const Real area = area2_of(region(trial, planes)), whole = std::abs(trial.area2());
            ASSERT_LT(abs(area2_of(polygon) - area), whole * Real(1e-30))
                << static_cast<double>(area / whole) << " of " << static_cast<double>(whole);
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                for (const HalfPlane& plane : planes)
                    ASSERT_GT(side(plane, polygon[i]), -sqrt(whole) * Real(1e-30)) << "corner " << i;
                const Real turn = truth::area2(polygon[i], polygon[(i + 1) % polygon.size()],
                                               polygon[(i + 2) % polygon.size()]);
                ASSERT_GE(turn * Real(trial.area2()), -whole * whole * Real(1e-30)) << "round the other way";
            }
        }
        EXPECT_GT(clear, all * 4 / 5) << "of " << all;
        if (away != 7 || cut != 0) EXPECT_GT(empty, all / 20);
        // Every number of edges that can be lost. Where two corners are cut and two edges lost, so is the
        // third corner, and everything.
        for (std::size_t size = truth::bit_count(cut) == 2 ? 4 : 3; size <= 3 + truth::bit_count(cut); ++size)
            EXPECT_GT(of_size[size], 3u) << size << " corners";
    });
}

TEST(remains, are_not_clear_where_rounding_decides) {
    // Edges of 3, 4 and 5: the inscribed circle's radius is 1.
    const Corners corners{Point{0, 0}, {4, 0}, {0, 3}};
    EXPECT_FALSE(truth::remains(corners, 1, 0, 0).is_clear);
    EXPECT_EQ(truth::remains(corners, 1 - 0x1p-17, 0, 0).corners.size(), 3u);
    EXPECT_TRUE(truth::remains(corners, 1 + 0x1p-17, 0, 0).is_clear);
    EXPECT_EQ(truth::remains(corners, 1 + 0x1p-17, 0, 0).corners.size(), 0u);
}

TEST(remains, begin_at_v0_and_end_before_it) {
    const Corners corners{Point{0, 0}, {4, 0}, {0, 3}};
    const auto lines = [&](double lambda, unsigned away, unsigned cut) {
        std::string text;
        for (const truth::RemainsCorner& corner : truth::remains(corners, lambda, away, cut).corners)
            text += fmt::format("{}{} ", corner.before, corner.behind);
        return text;
    };
    EXPECT_EQ(lines(0.5, 0, 0), "51 13 35 ");
    EXPECT_EQ(lines(0.5, 7, 7), "01 12 23 34 45 50 ");
    EXPECT_EQ(lines(0, 7, 7), lines(0.5, 7, 7)) << "at one place, but as many";
    EXPECT_EQ(lines(0.5, 3, 2), "51 12 23 35 ");
    EXPECT_EQ(lines(1.4, 7, 7), "01 12 23 34 40 ") << "the edge of length 3 is lost to its cuts";
    EXPECT_EQ(lines(1.9, 7, 7), "02 24 40 ") << "all are";
}

} // namespace
} // namespace gnomon
