// Two references that differ in kind, against each other: the twelve cases' formulas, composed, and lines in
// the plane of the mask.
#include "casegen/reference/mask_space.h"

#include "tests/support/masks.h"
#include "tests/support/smsr_chain.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::ivec2;
using testing::SmsrChain;

/// A point lies on the border of light and shadow where L q = k + c for a whole k: the position along a run
/// of L texels equals the distance from the side. There rounding decides, so that points of which none is
/// that near to any such line let the two be compared without tolerance.
double distance_to_nearest_tie(dvec2 p) {
    double nearest = 1;
    for (int axis = 0; axis < 2; ++axis)
        for (int length = 1; length <= 16; ++length)
            for (const double q : {p[1 - axis], 1 - p[1 - axis]})
                for (const double c : {p[axis], 1 - p[axis]}) {
                    const double k = length * q - c;
                    nearest = std::min(nearest, std::abs(k - std::round(k)) / length);
                }
    return nearest;
}

std::vector<dvec2> points_off_the_ties() {
    const std::vector<dvec2> points{{0.1237, 0.3391}, {0.7713, 0.0911}, {0.5171, 0.8837},
                                    {0.9419, 0.6173}, {0.2879, 0.1153}, {0.3713, 0.7177}};
    for (const dvec2 p : points) EXPECT_GT(distance_to_nearest_tie(p), 1e-6) << p.x << " " << p.y;
    return points;
}

std::string describe(const Mask& mask, ivec2 texel, dvec2 p) {
    return fmt::format("texel {},{} at {},{} of\n{}", texel.x, texel.y, p.x, p.y, format_mask(mask, '\n'));
}

/// Compares on every lit texel (shadowed ones are 0 in both by their first line); returns how many values.
std::size_t compare(const Mask& mask, SmsrChain& chain) {
    std::size_t compared = 0;
    testing::for_lit_texels(mask, [&](ivec2 texel) {
        const std::vector<double>& wanted = chain.values(reference::edge(mask, texel));
        for (std::size_t i = 0; i < wanted.size(); ++i, ++compared) {
            const dvec2 p = chain.points()[i];
            ASSERT_EQ(reference::smsr_visibility_in_mask_space(mask, texel, p), wanted[i])
                << describe(mask, texel, p);
        }
    });
    return compared;
}

class mask_space : public ::testing::TestWithParam<Outside> {};

TEST_P(mask_space, agrees_with_the_cases_on_all_4x4_masks) {
    SmsrChain chain(points_off_the_ties());
    std::size_t compared = 0;
    testing::for_all_4x4_masks(GetParam(), [&](const Mask& mask) {
        if (!HasFatalFailure()) compared += compare(mask, chain);
    });
    EXPECT_EQ(compared, (std::size_t{1} << 16) * 8 * chain.points().size());
}

INSTANTIATE_TEST_SUITE_P(surround, mask_space,
                         ::testing::Values(Outside::lit, Outside::shadow, Outside::clamp));

TEST(mask_space_families, agrees_with_the_cases_on_every_texel) {
    SmsrChain chain(points_off_the_ties());
    std::size_t compared = 0;
    for (const NamedMask& named : mask_corpus(11, 12, 40)) {
        SCOPED_TRACE(named.name);
        compared += compare(named.mask, chain);
        ASSERT_FALSE(HasFatalFailure());
    }
    EXPECT_GT(compared, 500000u);
}

// On a grid that does hit ties: there either side is right, by as much as a rounding moves the point.
TEST(mask_space_families, agrees_with_the_cases_on_a_grid_up_to_ties) {
    constexpr double rounding = 1e-9;
    std::vector<dvec2> grid;
    for (const double y : {0.0, 0.25, 0.5, 0.7, 1.0})
        for (const double x : {0.0, 0.3, 0.5, 0.75, 1.0}) grid.emplace_back(x, y);
    SmsrChain chain(grid);
    std::size_t compared = 0, ties = 0;
    for (const NamedMask& named : mask_corpus(12, 4, 32))
        testing::for_lit_texels(named.mask, [&](ivec2 texel) {
            const reference::Edge edge = reference::edge(named.mask, texel);
            const std::vector<double>& wanted = chain.values(edge);
            for (std::size_t i = 0; i < grid.size(); ++i, ++compared) {
                const double got = reference::smsr_visibility_in_mask_space(named.mask, texel, grid[i]);
                if (got == wanted[i]) continue;
                ++ties;
                EXPECT_LT(distance_to_nearest_tie(grid[i]), rounding) << describe(named.mask, texel, grid[i]);
                bool near = false;
                for (const dvec2 d : {dvec2(1, 1), dvec2(1, -1), dvec2(-1, 1), dvec2(-1, -1)})
                    near = near || testing::smsr_by_cases(edge, grid[i] + rounding * d) == got;
                EXPECT_TRUE(near) << describe(named.mask, texel, grid[i]);
            }
        });
    EXPECT_GT(compared, 300000u);
    EXPECT_LT(ties, compared / 200);
    RecordProperty("ties", static_cast<int>(ties));
}

TEST(mask_space_families, shadowed_texels_stay_dark) {
    for (const NamedMask& named : mask_corpus(13, 1, 16))
        for (int y = 0; y < named.mask.height; ++y)
            for (int x = 0; x < named.mask.width; ++x)
                if (!named.mask.lit(x, y))
                    ASSERT_EQ(reference::smsr_visibility_in_mask_space(named.mask, {x, y}, {0.5, 0.5}), 0);
}

// A worked example, by hand: a staircase with steps of 4, the line from (0,1) to (4,2) of the mask below.
TEST(mask_space_by_hand, a_step_of_four_texels) {
    Mask mask = parse_mask(".....\n#....\n#####\n", '\n', "m");
    for (int x = 1; x <= 4; ++x)
        for (const double px : {0.25, 0.75})
            for (const double py : {0.1, 0.35, 0.6, 0.85}) {
                if (x == 4) continue; // clamped, its run goes on beyond the border
                // The run begins nowhere within 16 texels: it is taken as 16 long.
                const double line = 1 + (x - 1 + px) / 16.0;
                EXPECT_EQ(reference::smsr_visibility_in_mask_space(mask, {x, 1}, {px, py}),
                          1 + py > line ? 0 : 1)
                    << x << " " << px << " " << py;
            }
}

} // namespace
} // namespace gnomon
