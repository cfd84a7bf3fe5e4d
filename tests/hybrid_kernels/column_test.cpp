// What is certain is true: the device's answers about triangles and rays that are known to within margins,
// against every true geometry that the margins leave room for, in whole numbers.
#include "tests/hybrid_kernels/column_trials.h"

#include <fmt/format.h>

#include <limits>

namespace gnomon::testing {
namespace {

/// Trials of all sizes: margins as the pipeline has them, and up to a thousand times as large.
const std::vector<ColumnTrial>& all_trials() {
    static const std::vector<ColumnTrial> all = column_trials(101, 30000);
    return all;
}

/// The same of places that are known exactly: what is left to be wrong is the kernels' own arithmetic.
const std::vector<ColumnTrial>& trials_without_margins() {
    static const std::vector<ColumnTrial> all = [] {
        std::vector<ColumnTrial> trials = column_trials(103, 30000);
        for (ColumnTrial& t : trials) t.margin = t.margin_z = 0;
        return trials;
    }();
    return all;
}

/// Whether the third corner is on one side of the edge wherever the margin lets all three be.
bool is_certain_of_third(const ColumnTrial& t, unsigned edge) {
    const auto at = [&](unsigned corner, unsigned where) {
        const LatticePoint& p = t.corners.p[(edge + corner) % 3];
        return LatticePoint{p.x + ((where & 1) != 0 ? t.margin : -t.margin),
                            p.y + ((where & 2) != 0 ? t.margin : -t.margin)};
    };
    const int side = sign(t.corners.area2());
    for (unsigned i = 0; i < 64; ++i)
        if (sign(area2(at(0, i & 3), at(1, i >> 2 & 3), at(2, i >> 4))) * side <= 0) return false;
    return true;
}

std::string said(std::size_t i, const ColumnTrial& t) {
    return fmt::format("trial {}: ({} {} {}) ({} {} {}) ({} {} {}) at {} {} {}, margins {} {} in 2^{}", i,
                       t.corners.p[0].x, t.corners.p[0].y, t.corners.p[0].z, t.corners.p[1].x,
                       t.corners.p[1].y, t.corners.p[1].z, t.corners.p[2].x, t.corners.p[2].y,
                       t.corners.p[2].z, t.origin.x, t.origin.y, t.origin.z, t.margin, t.margin_z,
                       t.exponent);
}

/// Counts what was wrong; the first few are told.
class Wrongs {
public:
    void add(std::size_t i, const ColumnTrial& trial, const std::string& what) {
        if (++count_ <= 3) ADD_FAILURE() << what << ", " << said(i, trial);
    }
    ~Wrongs() { EXPECT_EQ(count_, 0u); }

private:
    std::size_t count_ = 0;
};

constexpr int moves = 24;

TEST(column_overlaps, misses_no_square_that_the_true_triangle_meets) {
    std::vector<Numbered> rows;
    for (const ColumnTrial& t : all_trials()) rows.push_back(t.flat({t.half() + 2 * t.real_margin()}));
    const auto results = run_numbers("column/overlaps", rows);
    Wrongs wrongs;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ColumnTrial& t = all_trials()[i];
        if (results[i] != 0) continue;
        ++apart;
        for (const LatticeTriangle& true_one : t.moved(moves))
            if (triangle_meets(true_one, t.origin, t.half_side)) wrongs.add(i, t, "missed");
    }
    EXPECT_GT(apart, 5000u);
    EXPECT_LT(apart, 25000u);
}

TEST(column_touches, misses_no_edge_that_truly_meets_the_square) {
    std::vector<Numbered> rows;
    for (const ColumnTrial& t : all_trials()) {
        Numbered row = t.flat({t.half() + 2 * t.real_margin()});
        row.erase(row.begin() + 4, row.begin() + 6);
        rows.push_back(row);
    }
    const auto results = run_numbers("column/touches", rows);
    Wrongs wrongs;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ColumnTrial& t = all_trials()[i];
        if (results[i] != 0) continue;
        ++apart;
        for (const LatticeTriangle& true_one : t.moved(moves))
            if (segment_meets(true_one.p[0], true_one.p[1], t.origin, t.half_side))
                wrongs.add(i, t, "missed");
    }
    EXPECT_GT(apart, 5000u);
    EXPECT_LT(apart, 29000u);
}

void expect_opposite_only_of_points_that_truly_are(const std::vector<ColumnTrial>& trials) {
    std::vector<Numbered> rows;
    for (const ColumnTrial& t : trials) rows.push_back(t.flat({t.real_margin()}));
    const auto results = run_numbers("column/opposite", rows);
    Wrongs wrongs;
    std::size_t sure = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ColumnTrial& t = trials[i];
        if (results[i] == 0) continue;
        ++sure;
        const std::vector<LatticePoint> others = t.moved_origins(moves);
        const std::vector<LatticeTriangle> true_ones = t.moved(moves);
        for (std::size_t k = 0; k < true_ones.size(); ++k) {
            const auto& p = true_ones[k].p;
            if (sign(area2(p[0], p[1], p[2])) * sign(area2(p[0], p[1], others[k])) >= 0)
                wrongs.add(i, t, "on one side");
        }
    }
    EXPECT_GT(sure, 2000u);
}
TEST(column_opposite, says_so_only_of_points_that_truly_are) {
    expect_opposite_only_of_points_that_truly_are(all_trials());
}
TEST(column_opposite, takes_no_side_from_its_own_rounding) {
    expect_opposite_only_of_points_that_truly_are(trials_without_margins());
}

void expect_coverage_never_certain_and_wrong(const std::vector<ColumnTrial>& trials,
                                             std::size_t least_of_one_edge) {
    std::vector<Numbered> rows;
    for (const ColumnTrial& t : trials) rows.push_back(t.flat({t.real_margin()}));
    const auto results = run_numbers("column/coverage", rows);
    Wrongs wrongs;
    std::array<std::size_t, 9> counts{};
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ColumnTrial& t = trials[i];
        ++counts.at(results[i]);
        for (const LatticeTriangle& true_one : t.moved(moves)) {
            if (results[i] == 8 && true_one.holds(t.origin)) wrongs.add(i, t, "not outside");
            if (results[i] == 0 && !true_one.holds_inside(t.origin)) wrongs.add(i, t, "not within");
            // One unsure edge: on its inner side, where that is certain, the point is within.
            for (unsigned edge = 0; edge < 3; ++edge) {
                if (results[i] != 1u << edge) continue;
                if (true_one.area2() == 0) wrongs.add(i, t, "no area");
                const Wide at = area2(true_one.p[edge], true_one.p[(edge + 1) % 3], t.origin);
                if (sign(at) * sign(true_one.area2()) > 0 && !true_one.holds(t.origin) &&
                    is_certain_of_third(t, edge))
                    wrongs.add(i, t, "beyond another edge");
            }
        }
    }
    EXPECT_GT(counts[0], 1000u);
    EXPECT_GT(counts[8], 1000u);
    for (const unsigned one_edge : {1u, 2u, 4u}) EXPECT_GT(counts[one_edge], least_of_one_edge) << one_edge;
}
TEST(column_coverage, is_never_certain_and_wrong) {
    expect_coverage_never_certain_and_wrong(all_trials(), 300);
}
TEST(column_coverage, is_never_made_certain_by_its_own_rounding) {
    expect_coverage_never_certain_and_wrong(trials_without_margins(), 30);
}

void expect_height_never_certain_and_wrong(const std::vector<ColumnTrial>& trials) {
    std::vector<Numbered> rows;
    for (const ColumnTrial& t : trials) rows.push_back(t.ray());
    const auto results = run_numbers("column/height", rows);
    Wrongs wrongs;
    std::array<std::size_t, 3> counts{};
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ColumnTrial& t = trials[i];
        ++counts.at(results[i]);
        for (const LatticeTriangle& true_one : t.moved(moves)) {
            // Should the ray pass it: a triangle without area is passed by none, but for edge-on rays, that
            // no one traces.
            if (results[i] == 2 || true_one.area2() == 0 || !true_one.holds(t.origin)) continue;
            for (const std::int64_t off : {-t.margin_z, std::int64_t{0}, t.margin_z}) {
                const int against = true_one.depth_against(t.origin, t.origin.z - t.tmin + off);
                if (results[i] == 0 && against < 0) wrongs.add(i, t, "above");
                if (results[i] == 1 && against > 0) wrongs.add(i, t, "below");
            }
        }
    }
    for (const std::size_t count : counts) EXPECT_GT(count, 2000u);
}
TEST(column_height, is_never_certain_and_wrong) { expect_height_never_certain_and_wrong(all_trials()); }
TEST(column_height, is_never_made_certain_by_its_own_rounding) {
    expect_height_never_certain_and_wrong(trials_without_margins());
}

TEST(column_hit, is_never_certain_and_wrong) {
    std::vector<Numbered> rows;
    for (const ColumnTrial& t : all_trials()) rows.push_back(t.ray());
    const auto results = run_numbers("column/hit", rows);
    Wrongs wrongs;
    std::array<std::size_t, 3> counts{};
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ColumnTrial& t = all_trials()[i];
        ++counts.at(results[i]);
        for (const LatticeTriangle& true_one : t.moved(moves)) {
            const bool passes = true_one.area2() != 0 && true_one.holds_inside(t.origin);
            const bool hits = passes && true_one.depth_against(t.origin, t.origin.z - t.tmin) < 0;
            if (results[i] == 0 && hits) wrongs.add(i, t, "hit");
            if (results[i] == 1 && !hits) wrongs.add(i, t, "missed");
        }
    }
    for (const std::size_t count : counts) EXPECT_GT(count, 300u);
}

TEST(column_depth_bounds, hold_all_of_the_true_triangle_over_the_true_square) {
    std::vector<Numbered> rows;
    for (const ColumnTrial& t : all_trials()) {
        Numbered row = t.deep({t.half() + 2 * t.real_margin(), t.real_margin()});
        rows.push_back(row);
    }
    const auto results = run_floats("column/depth_bounds", rows);
    Wrongs wrongs;
    std::size_t compared = 0, inner = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ColumnTrial& t = all_trials()[i];
        // Outward to whole numbers; depths themselves may be margin_z wrong.
        const auto nearest = static_cast<std::int64_t>(std::floor(std::ldexp(results[2 * i], -t.exponent)));
        const auto farthest =
            static_cast<std::int64_t>(std::ceil(std::ldexp(results[2 * i + 1], -t.exponent)));
        Random random(102, i);
        bool narrow = nearest > std::min({t.corners.p[0].z, t.corners.p[1].z, t.corners.p[2].z});
        for (const LatticeTriangle& true_one : t.moved(moves)) {
            if (true_one.area2() == 0) continue;
            for (int k = 0; k < 6; ++k) {
                const LatticePoint at =
                    k < 4 ? square_round(t.origin, t.half_side).at(static_cast<std::size_t>(k))
                          : t.in_square(random);
                if (!true_one.holds(at)) continue;
                ++compared;
                if (narrow) ++inner;
                if (true_one.depth_against(at, nearest - t.margin_z) < 0) wrongs.add(i, t, "nearer");
                if (true_one.depth_against(at, farthest + t.margin_z) > 0) wrongs.add(i, t, "farther");
            }
        }
    }
    EXPECT_GT(compared, 100000u);
    EXPECT_GT(inner, 10000u) << "bounds by planes were not tried";
}

TEST(column_depth_bounds, of_a_triangle_without_depths_are_no_bounds) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto results = run_floats("column/depth_bounds", {{0, 0, nan, 4, 0, nan, 0, 4, nan, 1, 1, 0.5, 0}});
    EXPECT_EQ(results, (std::vector<double>{-std::numeric_limits<double>::infinity(),
                                            std::numeric_limits<double>::infinity()}));
}

} // namespace
} // namespace gnomon::testing
