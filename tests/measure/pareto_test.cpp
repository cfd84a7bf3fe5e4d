#include "casegen/measure/pareto.h"

#include "casegen/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon::measure {
namespace {

using ::testing::ElementsAre;
using By = std::optional<std::size_t>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double noise = 0.05;

auto by(std::vector<Point> points) { return dominated_by(points, noise); }

TEST(pareto, slower_and_less_accurate_is_dominated) {
    EXPECT_THAT(by({{10, 1e-7}, {20, 1e-6}}), ElementsAre(By{}, By{0}));
    EXPECT_THAT(by({{10, 1e-6}, {20, 1e-7}}), ElementsAre(By{}, By{}));
    EXPECT_THAT(by({}), ElementsAre());
    EXPECT_THAT(by({{10, 1}}), ElementsAre(By{}));
}

TEST(pareto, within_the_noise_no_time_is_a_difference) {
    EXPECT_THAT(by({{10, 1e-7}, {10.4, 1e-7}}), ElementsAre(By{}, By{}));
    EXPECT_THAT(by({{10, 1e-7}, {10.6, 1e-7}}), ElementsAre(By{}, By{0}));
    // Who seems slower within the noise may be slower: noise works against the claim.
    EXPECT_THAT(by({{10.4, 1e-8}, {10, 1e-7}}), ElementsAre(By{}, By{}));
    EXPECT_THAT(by({{10, 1e-8}, {10, 1e-7}}), ElementsAre(By{}, By{0}));
    EXPECT_THAT(by({{10.6, 1e-8}, {10, 1e-7}}), ElementsAre(By{}, By{}));
}

TEST(pareto, equals_do_not_dominate_each_other) {
    EXPECT_THAT(by({{10, 1e-7}, {10, 1e-7}}), ElementsAre(By{}, By{}));
    EXPECT_THAT(by({{10, infinity}, {10, std::nan("")}}), ElementsAre(By{}, By{}));
}

TEST(pareto, errors_that_are_not_finite_are_the_largest) {
    EXPECT_THAT(by({{10, infinity}, {10, 1e9}}), ElementsAre(By{1}, By{}));
    EXPECT_THAT(by({{10, std::nan("")}, {10, 1e9}}), ElementsAre(By{1}, By{}));
    EXPECT_THAT(by({{5, std::nan("")}, {10, infinity}}), ElementsAre(By{}, By{0}));
    EXPECT_THAT(by({{5, infinity}, {10, 1e9}}), ElementsAre(By{1}, By{})); // a fast wrong number
}

TEST(pareto, the_most_accurate_of_several_is_named) {
    EXPECT_THAT(by({{30, 1}, {20, 0.1}, {25, 0.01}}), ElementsAre(By{2}, By{}, By{}));
    EXPECT_THAT(by({{30, 1}, {20, 0.1}, {10, 0.1}}), ElementsAre(By{2}, By{2}, By{}));
}

TEST(pareto, somebody_is_never_dominated_and_domination_goes_in_no_circle) {
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        std::vector<Point> points(2 + random.below(8));
        for (Point& point : points) {
            point = {1 + 0.2 * random.unit(), static_cast<double>(random.below(4))};
            if (random.chance(0.1)) point.error = std::nan("");
        }
        const std::vector<By> found = by(points);
        for (std::size_t n = 0; n < points.size(); ++n) {
            std::size_t at = n, steps = 0;
            while (found[at] && steps++ <= points.size()) at = *found[at];
            ASSERT_LE(steps, points.size()) << "a circle";
        }
    }
}

} // namespace
} // namespace gnomon::measure
