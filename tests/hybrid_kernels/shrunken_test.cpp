// What the adjacency kernels emit, triangle by triangle, against the region that they are to cover.
#include "casegen/reference/hybrid/remains.h"
#include "tests/hybrid_kernels/region.h"

#include <fmt/format.h>

namespace gnomon {
namespace {

using namespace testing;
namespace truth = hybrid_truth;

/// One kernel's way to ask: how many triangles at most, and which bits.
struct Asked {
    const char* kernel;
    std::size_t triangles;
    unsigned away, inner;
    bool has_away, has_inner;
    unsigned cut() const { return truth::between(away) & ~inner; }
    std::string name() const { return fmt::format("{}_{}_{}", kernel + 10, away, inner); }
};

std::vector<Asked> all_ways() {
    std::vector<Asked> ways{{"adjacency/shadowed_0", 1, 0, 0, false, false},
                            {"adjacency/shadowed_3", 4, 7, 0, false, false}};
    for (unsigned away = 0; away < 8; ++away) {
        const unsigned count = truth::bit_count(away);
        if (count == 1) ways.push_back({"adjacency/shadowed_1", 1, away, 0, true, false});
        if (count == 2) ways.push_back({"adjacency/shadowed_2", 2, away, 0, true, false});
        ways.push_back({"adjacency/shrunken", 4, away, 0, true, false});
        for (unsigned inner = 0; inner < 8; ++inner)
            ways.push_back({"adjacency/one_ring", 4, away, inner, true, true});
    }
    return ways;
}

Numbered row_of(const Asked& asked, const Trial& trial) {
    Numbered row = trial.numbers();
    if (asked.has_away) row.push_back(asked.away);
    if (asked.has_inner) row.push_back(asked.inner);
    return row;
}

/// By the part of a kernel's name behind the /, in all ways to ask it.
class shrunken : public ::testing::TestWithParam<const char*> {
protected:
    static std::vector<Asked> ways() {
        std::vector<Asked> some = all_ways();
        std::erase_if(some, [](const Asked& asked) {
            return std::string(asked.kernel) != std::string("adjacency/") + GetParam();
        });
        EXPECT_FALSE(some.empty());
        return some;
    }
};

/// Whether no edge is lost: as many corners as the thesis's figures show.
bool is_whole(const Trial& trial, const Asked& asked, double lambda) {
    const truth::Remains remains = truth::remains(trial.corners, lambda, asked.away, asked.cut());
    return remains.is_clear && remains.corners.size() == 3 + truth::bit_count(asked.cut());
}

void expect_region(const Asked& asked) {
    SCOPED_TRACE(asked.name());
    const std::vector<Trial> all = trials(91, 800, hybrid::shrunken_triangles("trials", {.distance = 6}));
    std::vector<Numbered> rows;
    for (const Trial& trial : all) rows.push_back(row_of(asked, trial));
    const auto triangles = emitted(asked.kernel, rows, asked.triangles);
    std::size_t compared = 0, empty = 0, crossed = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Trial& trial = all[i];
        const std::string where = fmt::format("trial {}, sine {}", i, trial.sine());
        if (!truth::is_clear(trial.sine())) continue;
        if (trial.sine() < truth::parallel) {
            EXPECT_EQ(area2_of(triangles[i]), 0) << where;
            continue;
        }
        const std::vector<HalfPlane> planes = half_planes(trial, asked.away, asked.cut());
        const Polygon<Real> wanted = region(trial, planes);
        const double area = static_cast<double>(area2_of(wanted)),
                     covered = static_cast<double>(area2_of(triangles[i]));
        // Every border may be off by this much, over no more than the triangle's own.
        const double border = trial.rounding() * 2 *
                              (truth::length(trial.corners[0], trial.corners[1]) +
                               truth::length(trial.corners[1], trial.corners[2]) +
                               truth::length(trial.corners[2], trial.corners[0]));
        ASSERT_NEAR(covered, area, border) << where;
        ASSERT_LE(covered, std::abs(trial.area2()) + border) << where;
        if (covered == 0) {
            ++empty;
            continue;
        }
        // Each triangle's corners in every half-plane, and all wound as the triangle: so none covers another,
        // and the areas' sum is that of their union.
        for (const Corners& each : triangles[i]) {
            const auto exact = as<Rational>(each);
            const Rational winding = truth::area2(exact[0], exact[1], exact[2]);
            if (static_cast<double>(winding) * trial.area2() < 0)
                ASSERT_LE(std::abs(static_cast<double>(winding)), border) << where << " is turned round";
            for (const HalfPlane& plane : planes)
                for (const auto& corner : as<Real>(each))
                    ASSERT_GE(static_cast<double>(side(plane, corner)), -2 * trial.rounding()) << where;
        }
        ++compared;
        if (!is_whole(trial, asked, trial.lambda)) ++crossed;
    }
    EXPECT_GT(compared, 100u);
    if (asked.away != 7 || asked.cut() != 0) EXPECT_GT(empty, 2u);
    if (asked.cut() != 0) EXPECT_GT(crossed, 3u) << "cuts that overlap were not tried";
}

TEST_P(shrunken, covers_its_region_and_nothing_else) {
    for (const Asked& asked : ways()) expect_region(asked);
}

void expect_triangles(const Asked& asked) {
    SCOPED_TRACE(asked.name());
    const unsigned corners = 3 + truth::bit_count(asked.cut());
    std::vector<Trial> all = trials(92, 400);
    std::erase_if(all, [&](const Trial& t) {
        return t.sine() < 0x1p-6 || t.lambda == 0 || t.rounding() > 0x1p-3 * t.lambda * t.sine() ||
               !is_whole(t, asked, 1.25 * t.lambda);
    });
    ASSERT_GT(all.size(), 40u);
    std::vector<Numbered> rows;
    for (const Trial& trial : all) rows.push_back(row_of(asked, trial));
    const auto triangles = emitted(asked.kernel, rows, asked.triangles);
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::size_t with_area = 0;
        for (const Corners& each : triangles[i]) with_area += area2_of(std::vector{each}) != 0 ? 1u : 0u;
        ASSERT_EQ(with_area, corners - 2) << "trial " << i;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            double nearest = INFINITY;
            for (const Corners& each : triangles[i])
                for (const Point& p : each) nearest = std::min(nearest, inside_edge(all[i].corners, edge, p));
            const double wanted = (asked.away >> edge & 1) != 0 ? 0 : all[i].lambda;
            ASSERT_NEAR(nearest, wanted, all[i].rounding()) << "trial " << i << ", edge " << edge;
        }
    }
}

TEST_P(shrunken, emits_as_many_triangles_as_the_thesis_says) {
    for (const Asked& asked : ways()) expect_triangles(asked);
}

INSTANTIATE_TEST_SUITE_P(of_all_kernels, shrunken,
                         ::testing::Values("shadowed_0", "shadowed_1", "shadowed_2", "shadowed_3", "shrunken",
                                           "one_ring"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(shrunken_values, an_uncut_corner_between_edges_that_stay_keeps_its_bits) {
    const std::vector<Trial> all = trials(93, 500);
    std::vector<Numbered> rows;
    for (const Trial& trial : all) rows.push_back(trial.numbers({7, 7}));
    const auto triangles = emitted("adjacency/one_ring", rows, 4);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].sine() < 2 * truth::parallel) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(triangles[i][0][k].x, all[i].corners[k].x);
            EXPECT_EQ(triangles[i][0][k].y, all[i].corners[k].y);
        }
    }
}

} // namespace
} // namespace gnomon
