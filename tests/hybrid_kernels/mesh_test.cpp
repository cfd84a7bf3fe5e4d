// What the triangles of a mesh cover together once each is shrunken between its neighbours.
#include "tests/hybrid_kernels/meshes.h"
#include "tests/hybrid_kernels/region.h"

#include <fmt/format.h>

namespace gnomon {
namespace {

using namespace testing;
namespace truth = hybrid_truth;

constexpr double lambda = 0x1p-6;

/// The triangles of a mesh that face away, what their neighbours ask for, and what the device emits.
struct Shrunken {
    Scene scene;
    Adjacency adjacency;
    std::vector<std::uint32_t> away;
    std::vector<Neighbours> around; // per triangle of the scene
    std::vector<std::uint32_t> ids; // of those that face away, as all that follows
    std::vector<Trial> trials;
    std::vector<unsigned> cut;
    std::vector<std::vector<Corners>> emitted;
};

Shrunken shrink(const Damage& damage, std::uint64_t seed, bool one_ring, Across across) {
    Shrunken mesh;
    mesh.scene = pillow(damage, 6, seed);
    mesh.adjacency = make_adjacency(mesh.scene);
    mesh.away = facing_away(mesh.scene, {0, 0, 1});
    mesh.around = neighbours(mesh.scene, mesh.adjacency, mesh.away, across);
    std::vector<Numbered> rows;
    for (std::uint32_t t = 0; t < mesh.scene.triangles.size(); ++t) {
        if (!is_set(mesh.away, t)) continue;
        Trial trial{.lambda = lambda};
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 p(mesh.scene.positions[mesh.scene.triangles[t][static_cast<int>(i)]]);
            trial.corners[i] = {p.x, p.y};
        }
        const unsigned away = mesh.around[t].away, inner = one_ring ? mesh.around[t].inner : 0;
        rows.push_back(one_ring ? trial.numbers({static_cast<double>(away), static_cast<double>(inner)})
                                : trial.numbers({static_cast<double>(away)}));
        mesh.ids.push_back(t);
        mesh.trials.push_back(trial);
        mesh.cut.push_back(truth::between(away) & ~inner);
    }
    mesh.emitted = testing::emitted(one_ring ? "adjacency/one_ring" : "adjacency/shrunken", rows, 4);
    return mesh;
}

/// Whether any emitted triangle holds p, each grown by `margin`.
bool is_covered(const Shrunken& mesh, const Point& p, double margin) {
    for (const std::vector<Corners>& triangles : mesh.emitted)
        for (const Corners& each : triangles)
            if (truth::least_sine(each) > 0 && inside(each, p) >= -margin) return true;
    return false;
}

class mesh : public ::testing::TestWithParam<Damage> {};

TEST_P(mesh, covers_where_one_of_its_triangles_should_and_nowhere_else) {
    for (const bool one_ring : {false, true}) {
        std::size_t covered = 0, bare = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const Shrunken shrunken =
                shrink(GetParam(), seed, one_ring, seed % 2 == 0 ? Across::facing : Across::sides);
            std::vector<std::vector<HalfPlane>> planes;
            double rounding = 0;
            for (std::size_t i = 0; i < shrunken.trials.size(); ++i) {
                planes.push_back(
                    half_planes(shrunken.trials[i], shrunken.around[shrunken.ids[i]].away, shrunken.cut[i]));
                rounding = std::max(rounding, shrunken.trials[i].rounding());
            }
            ASSERT_LT(rounding, lambda / 16);
            Random random(seed, 5);
            for (int sample = 0; sample < 400; ++sample) {
                const Point p{2 * random.unit() - 1, 2 * random.unit() - 1};
                const truth::Point<Real> exact{p.x, p.y};
                double deepest = -INFINITY; // how far p is inside the region that holds it best
                for (const std::vector<HalfPlane>& each : planes) {
                    double least = INFINITY;
                    for (const HalfPlane& plane : each)
                        least = std::min(least, static_cast<double>(side(plane, exact)));
                    deepest = std::max(deepest, least);
                }
                if (std::abs(deepest) < 4 * rounding) continue; // on a border
                ASSERT_EQ(is_covered(shrunken, p, rounding), deepest > 0)
                    << fmt::format("seed {}, ({}, {}), {} inside", seed, p.x, p.y, deepest);
                (deepest > 0 ? covered : bare) += 1;
            }
        }
        EXPECT_GT(covered, 100u);
        EXPECT_GT(bare, 100u);
    }
}

TEST_P(mesh, stays_within_its_silhouette) {
    for (const bool one_ring : {false, true})
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const Shrunken shrunken =
                shrink(GetParam(), seed, one_ring, seed % 2 == 0 ? Across::facing : Across::sides);
            for (std::size_t i = 0; i < shrunken.trials.size(); ++i)
                for (const Corners& each : shrunken.emitted[i])
                    for (const Point& p : each)
                        ASSERT_GE(inside(shrunken.trials[i].corners, p), -shrunken.trials[i].rounding());
        }
}

TEST_P(mesh, does_not_tear_along_edges_between_two_triangles_that_face_away) {
    std::size_t edges = 0;
    for (const bool one_ring : {false, true})
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const Shrunken shrunken = shrink(GetParam(), seed, one_ring, Across::sides);
            for (std::size_t i = 0; i < shrunken.trials.size(); ++i)
                for (std::uint32_t e = 0; e < 3; ++e) {
                    const std::uint32_t half_edge = 3 * shrunken.ids[i] + e,
                                        other = shrunken.adjacency.next[half_edge];
                    if (other <= half_edge || shrunken.adjacency.next[other] != half_edge ||
                        (shrunken.around[shrunken.ids[i]].away >> e & 1) == 0)
                        continue;
                    // Both keep the edge but for lambda over a sine at its ends: on both sides of its middle
                    // there is no gap wider than rounding.
                    const Trial& trial = shrunken.trials[i];
                    const Point &a = trial.corners[e], &b = trial.corners[(e + 1) % 3];
                    const auto found = std::ranges::find(shrunken.ids, other / 3);
                    ASSERT_NE(found, shrunken.ids.end());
                    const Trial& across =
                        shrunken.trials[static_cast<std::size_t>(found - shrunken.ids.begin())];
                    const double sine = std::min(trial.sine(), across.sine());
                    if (truth::length(a, b) < 2.5 * lambda / sine) continue; // cuts may meet
                    const auto line = truth::edge(trial.corners, e, 0.0);
                    const double aside = 4 * std::max(trial.rounding(), across.rounding());
                    for (const double sign : {-1.0, 1.0}) {
                        const Point p{0.5 * (a.x + b.x) + sign * aside * line.a,
                                      0.5 * (a.y + b.y) + sign * aside * line.b};
                        ASSERT_TRUE(is_covered(shrunken, p, aside / 2)) << "half-edge " << half_edge;
                    }
                    ++edges;
                }
        }
    EXPECT_GT(edges, 200u);
}

TEST_P(mesh, has_holes_at_inner_vertices_unless_one_rings_are_known) {
    std::size_t vertices = 0, holes = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Shrunken by_edges = shrink(GetParam(), seed, false, Across::sides),
                       by_rings = shrink(GetParam(), seed, true, Across::sides);
        for (std::size_t i = 0; i < by_rings.trials.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                if ((by_rings.around[by_rings.ids[i]].inner >> k & 1) == 0) continue;
                const Point& corner = by_rings.trials[i].corners[k];
                const double rounding = by_rings.trials[i].rounding();
                ASSERT_TRUE(is_covered(by_rings, corner, 0)) << "a corner that is not cut keeps its bits";
                for (int direction = 0; direction < 12; ++direction) {
                    const double angle = direction * 0.5236;
                    const Point p{corner.x + lambda / 8 * std::cos(angle),
                                  corner.y + lambda / 8 * std::sin(angle)};
                    ASSERT_TRUE(is_covered(by_rings, p, rounding));
                }
                ++vertices;
                holes += is_covered(by_edges, corner, rounding) ? 0u : 1u;
            }
    }
    EXPECT_GT(vertices, 50u);
    // Another triangle may lie over one: a duplicate does not, it is cut too; a fin does.
    EXPECT_GT(10 * holes, 9 * vertices);
}

INSTANTIATE_TEST_SUITE_P(of_all_kinds, mesh, ::testing::ValuesIn(damages),
                         [](const auto& instance) { return std::string(instance.param.name); });

} // namespace
} // namespace gnomon
