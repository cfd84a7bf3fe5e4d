// SMSR against the line that a half-plane's shadow has. docs/revectorization.md 3.2
//
// The edge band is every texel, lit or shadowed, with a neighbour on one of its four sides that differs: two
// texels high for a line flatter than 45 degrees. All areas are fractions of it.
#include "casegen/reference/mask_space.h"

#include "casegen/mask_families.h"
#include "casegen/random.h"
#include "casegen/symmetry.h"
#include "tests/support/masks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::ivec2;

constexpr int size = 80, margin = 20; // the map's border changes runs near it
constexpr int grid = 8;               // points per texel and axis
constexpr int offsets = 8;

/// Misclassified area in percent of the edge band.
struct Misclassified {
    double hard = 0;       ///< by the shadow test alone, against the true line
    double smsr = 0;       ///< by SMSR, against the true line
    double smsr_moved = 0; ///< by SMSR, against the line moved by half a texel towards the light
    double bias = 0;       ///< darkened less lit wrongly, by SMSR against the true line
};

/// A line of `slope` between 0 and 1 in one of eight orientations.
Misclassified misclassified(double slope, unsigned orientation, std::uint64_t seed) {
    std::vector<const Symmetry*> turns;
    for (unsigned bit = 0; bit < 3; ++bit)
        if ((orientation & (1u << bit)) != 0) turns.push_back(&symmetries[bit]);

    Random random(51, seed);
    Misclassified result;
    std::size_t samples = 0;
    for (int n = 0; n < offsets; ++n) {
        const double offset = size / 2.0 - slope * size / 2.0 + (n + random.unit()) / offsets;
        const Mask upright = half_plane(size, slope, -1, -offset); // shadow where y > slope x + offset
        Mask turned = upright;
        for (const Symmetry* turn : turns) turned = turn->of_mask(turned);
        for (int y = 1; y < size - 1; ++y)
            for (int x = margin; x < size - margin; ++x) {
                if (reference::discontinuity(upright, {x, y}) == glm::uvec2(0)) continue;
                for (int i = 0; i < grid * grid; ++i, ++samples) {
                    const dvec2 p((i % grid + 0.5) / grid, (i / grid + 0.5) / grid);
                    ivec2 texel(x, y);
                    dvec2 point = p;
                    Mask const* mask = &upright; // texels move within a square: any of the masks says how
                    for (const Symmetry* turn : turns) {
                        texel = turn->of_texel(*mask, texel);
                        point = turn->of_point(point);
                    }
                    const bool lit = reference::smsr_visibility_in_mask_space(turned, texel, point) == 1;
                    const double below = y + p.y - (slope * (x + p.x) + offset);
                    result.hard += upright.lit(x, y) != (below <= 0) ? 1 : 0;
                    result.smsr += lit != (below <= 0) ? 1 : 0;
                    result.bias += (below <= 0 ? 1 : 0) - (lit ? 1 : 0);
                    result.smsr_moved += lit != (below + 0.5 <= 0) ? 1 : 0;
                }
            }
    }
    for (double* area : {&result.hard, &result.smsr, &result.smsr_moved, &result.bias})
        *area *= 100 / static_cast<double>(samples);
    return result;
}

Misclassified mean_over_orientations(double slope) {
    Misclassified mean;
    for (unsigned orientation = 0; orientation < 8; ++orientation) {
        const Misclassified one = misclassified(slope, orientation, orientation);
        mean.hard += one.hard / 8;
        mean.smsr += one.smsr / 8;
        mean.smsr_moved += one.smsr_moved / 8;
        mean.bias += one.bias / 8;
    }
    return mean;
}

TEST(half_planes, smsr_straightens_the_edge_and_moves_it_half_a_texel_into_the_light) {
    constexpr std::array slopes{1 / 32.0, 1 / 16.0, 0.1,     1 / 8.0, 1 / 6.0, 0.2,  0.25, 0.3,
                                1 / 3.0,  0.4,      1 / 2.0, 0.6,     2 / 3.0, 0.75, 0.9,  1.0};
    Misclassified mean;
    fmt::print("slope   hard test   SMSR   SMSR against the moved line   (% of the edge band)\n");
    for (const double slope : slopes) {
        const Misclassified area = mean_over_orientations(slope);
        fmt::print("{:.4f} {:9.2f} {:8.2f} {:12.2f}\n", slope, area.hard, area.smsr, area.smsr_moved);
        mean.hard += area.hard / slopes.size();
        mean.smsr += area.smsr / slopes.size();
        if (slope >= 1 / 16.0 && slope <= 0.75) {
            EXPECT_GT(area.smsr_moved, 0.2) << slope;
            EXPECT_LT(area.smsr_moved, 7) << slope;
            EXPECT_NEAR(area.bias, 25, 4) << slope << ": half a texel of a band of two";
        }
        if (slope == 0.9) EXPECT_NEAR(area.smsr_moved, 10, 1.5);
        // Runs longer than 16 texels fade out: little is moved, and little is straightened.
        if (slope < 1 / 16.0) EXPECT_GT(area.smsr_moved, 7) << slope;
    }
    fmt::print("mean   {:9.2f} {:8.2f}\n", mean.hard, mean.smsr);
    EXPECT_NEAR(mean.hard, 13.1, 0.7);
    EXPECT_NEAR(mean.smsr, 22.5, 1.5);
}

TEST(half_planes, no_orientation_is_favoured) {
    const Misclassified upright = misclassified(0.3, 0, 0);
    for (unsigned orientation = 1; orientation < 8; ++orientation)
        EXPECT_NEAR(misclassified(0.3, orientation, 0).smsr, upright.smsr, 0.01) << orientation;
}

TEST(half_planes, axis_aligned_edges_stay_where_the_texels_put_them) {
    const Mask mask = half_plane(40, 0, -1, -20.5); // shadow from row 21 on: runs of more than 16 texels
    for (int x = 0; x < 40; ++x)
        for (const double y : {0.1, 0.5, 0.99})
            EXPECT_EQ(reference::smsr_visibility_in_mask_space(mask, {x, 20}, {0.5, y}), 1) << x;
}

} // namespace
} // namespace gnomon
