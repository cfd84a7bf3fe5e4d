// How far RSMSS jumps where two texels meet: a ramp ought not to, but corners, slots and what walks cannot
// see make it. docs/revectorization.md 5.3
#include "casegen/reference/rsmss.h"

#include "casegen/mask_families.h"
#include "tests/support/techniques.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::ivec2;

struct Jump {
    double sum = 0, largest = 0;
    std::size_t points = 0;
    double mean() const { return sum / static_cast<double>(points); }
};

/// Over the borders of texels of which at least one has a side, at four points each, within the mask.
template <typename Visibility>
void add_jumps(const Mask& mask, const Visibility& visibility, Jump& jump) {
    const auto has_side = [&](ivec2 t) { return reference::discontinuity(mask, t) != glm::uvec2(0); };
    for (int y = 0; y + 1 < mask.height; ++y)
        for (int x = 0; x + 1 < mask.width; ++x)
            for (const ivec2 step : {ivec2(1, 0), ivec2(0, 1)}) {
                const ivec2 here(x, y), next = here + step;
                if (!has_side(here) && !has_side(next)) continue;
                for (const double along : {0.1, 0.4, 0.7, 0.95}) {
                    const dvec2 p = step.x == 1 ? dvec2(1, along) : dvec2(along, 1);
                    const double difference =
                        std::abs(visibility(mask, here, p) - visibility(mask, next, p - dvec2(step)));
                    jump.sum += difference;
                    jump.largest = std::max(jump.largest, difference);
                    ++jump.points;
                }
            }
}

const std::vector<NamedMask>& corpus() {
    static const std::vector<NamedMask> masks = mask_corpus(81, 10, 32);
    return masks;
}

Jump jump_with(unsigned options, bool flip_isolated = false) {
    Jump jump;
    for (const NamedMask& named : corpus())
        add_jumps(
            flip_isolated ? without_isolated(named.mask) : named.mask,
            [&](const Mask& mask, ivec2 t, dvec2 p) {
                return reference::rsmss_visibility_in_mask_space(mask, t, p, options);
            },
            jump);
    return jump;
}

TEST(continuity, half_planes_jump_only_at_corners_that_a_surround_makes) {
    Jump hard, soft;
    for (const NamedMask& named : corpus())
        if (named.name.starts_with("half-planes")) {
            add_jumps(named.mask, testing::hard_test.visibility, hard);
            add_jumps(named.mask, testing::rsmss.visibility, soft);
        }
    fmt::print("half-planes: mean jump {:.4f} (hard test {:.4f}), largest {:.3f}\n", soft.mean(), hard.mean(),
               soft.largest);
    EXPECT_LT(soft.mean(), 0.002);
    EXPECT_NEAR(soft.largest, 0.5625, 1e-9); // without a surround's border: none, see exact_shapes
    EXPECT_GT(hard.mean(), 0.2);
}

// Pinned: a change of a formula or a decision shows here even if both references change with it.
TEST(continuity, mean_and_largest_jump_of_every_reading) {
    struct Reading {
        const char* name;
        unsigned options;
        bool flip_isolated;
        double mean;
    };
    const std::array readings{
        Reading{"recommended", 0, false, 0.09325},
        Reading{"A3 printed end", reference::printed_end, false, 0.10117},
        Reading{"A4 first opening", reference::first_opening, false, 0.09832},
        Reading{"A5 first breach", reference::first_breach, false, 0.09864},
        Reading{"A5 opposite breach", reference::opposite_breach, false, 0.10470},
        Reading{"A6 ramped bar", reference::ramped_bar, false, 0.08931},
        Reading{"A7 long runs", reference::long_runs, false, 0.08906},
        Reading{"A8 breach by position", reference::breach_by_position, false, 0.09291},
        Reading{"A9 isolated texels flipped", 0, true, 0.07858},
    };
    fmt::print("reading                        mean jump   largest\n");
    for (const Reading& reading : readings) {
        const Jump jump = jump_with(reading.options, reading.flip_isolated);
        fmt::print("{:<28} {:>10.5f} {:>9.3f}\n", reading.name, jump.mean(), jump.largest);
        EXPECT_NEAR(jump.mean(), reading.mean, 6e-6) << reading.name;
        EXPECT_EQ(jump.largest, 1) << "a slot's dark end beside light";
    }
}

TEST(continuity, mean_and_largest_jump_by_family) {
    const std::map<std::string, std::pair<double, double>> pinned{
        {"blobs", {0.00113, 0.7375}},      {"circles", {0.00000, 0.0000}},
        {"combs", {0.07073, 0.9969}},      {"half-planes", {0.00080, 0.5625}},
        {"mazes", {0.13854, 1.0000}},      {"noise", {0.15724, 1.0000}},
        {"rectangles", {0.01123, 0.6219}}, {"segments", {0.04957, 1.0000}},
        {"shapes", {0.05870, 1.0000}},     {"single-texels", {0.00445, 0.9500}},
        {"thin-strips", {0.04946, 1.0000}}};
    std::map<std::string, Jump> jumps;
    for (const NamedMask& named : corpus())
        add_jumps(named.mask, testing::rsmss.visibility, jumps[named.name.substr(0, named.name.find('/'))]);
    fmt::print("family           mean jump   largest\n");
    for (const auto& [family, jump] : jumps) {
        fmt::print("{:<16} {:>9.5f} {:>9.4f}\n", family, jump.mean(), jump.largest);
        if (!pinned.contains(family)) {
            ADD_FAILURE() << family;
            continue;
        }
        EXPECT_NEAR(jump.mean(), pinned.at(family).first, 6e-6) << family;
        EXPECT_NEAR(jump.largest, pinned.at(family).second, 6e-5) << family;
    }
}

} // namespace
} // namespace gnomon
