// The decision list, by the cases' own conditions: total, without overlap, over every edge that a mask can
// have. docs/revectorization.md 2.1
#include "tests/support/masks.h"
#include "tests/support/smsr_chain.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace gnomon {
namespace {

using reference::both;
using reference::minus;
using reference::neither;
using reference::plus;

/// Every edge of lit texels that differs in what the decision list reads: of all 4x4 masks in light and in
/// shadow, and of masks of all families.
const std::map<std::uint64_t, reference::Edge>& realisable_edges() {
    static const auto edges = [] {
        std::map<std::uint64_t, reference::Edge> found;
        const auto collect = [&](const Mask& mask) {
            testing::for_lit_texels(mask, [&](glm::ivec2 texel) {
                const reference::Edge edge = reference::edge(mask, texel);
                found.emplace(testing::decision_key(edge), edge);
            });
        };
        for (const Outside outside : {Outside::lit, Outside::shadow})
            testing::for_all_4x4_masks(outside, collect);
        for (const NamedMask& named : mask_corpus(21, 20, 40)) collect(named.mask);
        return found;
    }();
    return edges;
}

unsigned number_by_list(const reference::Edge& e);

TEST(decision, exactly_one_case_applies_to_every_edge) {
    std::map<unsigned, int> edges_of;
    for (const auto& [key, edge] : realisable_edges()) {
        int applying = 0;
        unsigned number = 0;
        for (const Case* c : testing::smsr_cases())
            if (applies(*c, edge)) ++applying, number = c->number;
        const bool is_edge = edge.sides != glm::uvec2(neither);
        EXPECT_EQ(applying, is_edge ? 1 : 0)
            << "sides " << edge.sides.x << edge.sides.y << " types " << edge.type.x << edge.type.y;
        EXPECT_EQ(number, number_by_list(edge));
        ++edges_of[number];
    }
    for (unsigned number = 0; number <= 12; ++number) EXPECT_GT(edges_of[number], 0) << "case " << number;
}

TEST(decision, number_of_realisable_edges) {
    EXPECT_EQ(realisable_edges().size(), 64u) << "63 that differ somewhere, and the texel amid equals";
}

/// docs/revectorization.md 2.1, line by line: the third statement of it besides conditions and kernel.
unsigned number_by_list(const reference::Edge& e) {
    if (e.sides.x == neither && e.sides.y == neither) return 0;
    if (e.sides.x == neither)
        return e.type.x == -1 ? 1 : e.type.x == 1 ? 2 : e.sides.y == both ? 3 : e.sides.y == plus ? 9 : 10;
    if (e.sides.y == neither)
        return e.type.y == -1 ? 1 : e.type.y == 1 ? 2 : e.sides.x == both ? 3 : e.sides.x == minus ? 11 : 12;
    if (e.sides.x == both && e.sides.y == both) return 3;
    if (e.sides.x == both || e.sides.y == both) return (e.sides.x == both ? e.type.y : e.type.x) == 1 ? 2 : 3;
    if (e.type.x == 1 || e.type.y == 1) return 2;
    if (e.dominant.x && e.dominant.y) return 8;
    if (e.dominant.x) return 4;
    if (e.dominant.y) return 5;
    return e.sides.y == plus ? 6 : 7;
}

// docs/revectorization.md 1.2
TEST(decision, a_corner_s_runs_always_have_an_end) {
    std::set<std::uint64_t> corners;
    for (const auto& [key, edge] : realisable_edges()) {
        const bool corner = edge.sides.x != neither && edge.sides.x != both && edge.sides.y != neither &&
                            edge.sides.y != both;
        if (!corner) {
            EXPECT_FALSE(edge.dominant.x || edge.dominant.y);
            continue;
        }
        corners.insert(key);
        EXPECT_NE(edge.type.x, -1);
        EXPECT_NE(edge.type.y, -1);
        if (edge.dominant.x && !edge.dominant.y) EXPECT_NE(edge.type.x, 1);
        if (edge.dominant.y && !edge.dominant.x) EXPECT_NE(edge.type.y, 1);
    }
    EXPECT_GE(corners.size(), 16u);
}

// docs/revectorization.md A1: across a side on both, both walks end at once.
TEST(decision, an_axis_with_a_side_has_ends_where_the_sides_are) {
    for (const auto& [key, edge] : realisable_edges()) {
        EXPECT_EQ(edge.reach.x == 1, (edge.sides.x & minus) != 0);
        EXPECT_EQ(edge.reach.y == 1, (edge.sides.x & plus) != 0);
        EXPECT_EQ(edge.reach.z == 1, (edge.sides.y & minus) != 0);
        EXPECT_EQ(edge.reach.w == 1, (edge.sides.y & plus) != 0);
        for (int i = 0; i < 4; ++i) {
            EXPECT_NE(edge.reach[i], 0);
            EXPECT_GE(edge.reach[i], -17);
            EXPECT_LE(edge.reach[i], 16);
        }
    }
}

} // namespace
} // namespace gnomon
