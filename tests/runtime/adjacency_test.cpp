// Which triangles meet, against searches of all pairs.
#include "runtime/adjacency.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

using ::testing::ElementsAre;
using testing::Random;

Scene scene_of(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
    Scene scene;
    scene.positions = std::move(positions);
    scene.normals.assign(scene.positions.size(), glm::vec3(0, 0, 1));
    scene.triangles = std::move(triangles);
    return scene;
}

/// A soup on few places: shared, doubled, folded and turned-round triangles, edges of no length, -0 and 0.
Scene soup(std::uint64_t seed, std::uint32_t triangles, std::uint32_t width) {
    Random random(seed);
    Scene scene;
    for (std::uint32_t t = 0; t < triangles; ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto coordinate = [&] {
                const float whole = static_cast<float>(random.below(width));
                return whole == 0 && random.below(2) == 0 ? -0.0f : whole;
            };
            const float x = coordinate(), y = coordinate();
            scene.positions.emplace_back(x, y, coordinate());
        }
        scene.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
    }
    scene.normals.assign(scene.positions.size(), glm::vec3(0, 0, 1));
    return scene;
}

glm::vec3 corner(const Scene& scene, std::size_t t, std::size_t i) {
    return scene.positions[scene.triangles[t][static_cast<int>(i % 3)]];
}
bool same_edge(const Scene& scene, std::size_t h, std::size_t k) {
    const glm::vec3 a = corner(scene, h / 3, h % 3), b = corner(scene, h / 3, h % 3 + 1);
    const glm::vec3 c = corner(scene, k / 3, k % 3), d = corner(scene, k / 3, k % 3 + 1);
    return a != b && ((a == c && b == d) || (a == d && b == c));
}

TEST(adjacency, is_what_a_search_of_all_pairs_finds) {
    std::size_t crowded = 0, alone = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Scene scene = soup(seed, 60, seed % 2 == 0 ? 3 : 2);
        const Adjacency adjacency = make_adjacency(scene);
        const std::size_t half_edges = 3 * scene.triangles.size();
        for (std::size_t v = 0; v < scene.positions.size(); ++v)
            for (std::size_t w = 0; w < v; ++w)
                ASSERT_EQ(adjacency.place[v] == adjacency.place[w], scene.positions[v] == scene.positions[w]);
        for (std::size_t h = 0; h < half_edges; ++h) {
            std::vector<std::uint32_t> expected{static_cast<std::uint32_t>(h)};
            for (std::size_t k = 1; k < half_edges; ++k)
                if (same_edge(scene, h, (h + k) % half_edges))
                    expected.push_back(static_cast<std::uint32_t>((h + k) % half_edges));
            std::vector<std::uint32_t> found{static_cast<std::uint32_t>(h)};
            for (std::uint32_t k = adjacency.next[h]; k != h && found.size() <= half_edges;
                 k = adjacency.next[k])
                found.push_back(k);
            ASSERT_EQ(found, expected) << "half-edge " << h << ", seed " << seed;
            crowded += found.size() > 2 ? 1u : 0u;
            alone += found.size() == 1 ? 1u : 0u;
        }
        for (std::size_t v = 0; v < scene.positions.size(); ++v) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
                for (std::size_t i = 0; i < 3; ++i)
                    if (corner(scene, t, i) == scene.positions[v] &&
                        (expected.empty() || expected.back() != t))
                        expected.push_back(t);
            ASSERT_TRUE(std::ranges::equal(adjacency.triangles_at(adjacency.place[v]), expected));
        }
    }
    EXPECT_GT(crowded, 100u);
    EXPECT_GT(alone, 100u);
}

TEST(adjacency, numbers_places_in_the_order_of_their_first_vertices) {
    const Scene scene =
        scene_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-0.0f, -0.0f, -0.0f}, {1, 1, 0}},
                 {{0, 1, 2}, {3, 5, 2}});
    const Adjacency adjacency = make_adjacency(scene);
    EXPECT_THAT(adjacency.place, ElementsAre(0u, 1u, 2u, 1u, 0u, 3u));
    EXPECT_EQ(adjacency.places, 4u);
    EXPECT_THAT(adjacency.next, ElementsAre(0u, 5u, 2u, 3u, 4u, 1u));
}

TEST(adjacency, of_nothing_is_nothing) {
    const Adjacency adjacency = make_adjacency({});
    EXPECT_EQ(adjacency.places, 0u);
    EXPECT_TRUE(adjacency.next.empty() && adjacency.ring.empty());
    EXPECT_TRUE(facing_away({}, {0, 0, 1}).empty());
    EXPECT_TRUE(neighbours({}, adjacency, {}).empty());
}

TEST(adjacency, vertices_without_triangles_have_empty_rings) {
    const Adjacency adjacency =
        make_adjacency(scene_of({{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 2, 3}}));
    EXPECT_TRUE(adjacency.triangles_at(0).empty());
    EXPECT_THAT(adjacency.triangles_at(1), ElementsAre(0u));
}

TEST(facing, is_the_winding_seen_from_the_light) {
    const Scene scene = scene_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}},
                                 {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}}); // up, down, a line
    EXPECT_THAT(facing_away(scene, {0, 0, 1}), ElementsAre(0b010u));
    EXPECT_THAT(facing_away(scene, {0, 0, -1}), ElementsAre(0b001u));
    EXPECT_THAT(facing_away(scene, {1, 1, 0}), ElementsAre(0u)); // edge-on
    EXPECT_THAT(facing_away_from_point(scene, {5, 5, 1e-3f}), ElementsAre(0b010u));
    EXPECT_THAT(facing_away_from_point(scene, {5, 5, -1e-3f}), ElementsAre(0b001u));
    EXPECT_THAT(facing_away_from_point(scene, {5, 5, 0}), ElementsAre(0u));
}

TEST(facing, has_a_bit_for_every_triangle) {
    const Scene scene = soup(7, 100, 5);
    const std::vector<std::uint32_t> away = facing_away(scene, {1, 2, 3}),
                                     back = facing_away(scene, {-1, -2, -3});
    ASSERT_EQ(away.size(), 4u);
    for (std::uint32_t t = 0; t < 100; ++t) {
        const glm::vec3 a = corner(scene, t, 0), b = corner(scene, t, 1), c = corner(scene, t, 2);
        const float side =
            glm::dot(glm::cross(b - a, c - a), glm::vec3(1, 2, 3)); // small whole numbers: exact
        EXPECT_EQ(is_set(away, t), side < 0) << t;
        EXPECT_EQ(is_set(back, t), side > 0) << t;
    }
}

/// A pyramid without a base: four triangles around corner 0, seen from below.
Scene pyramid() {
    return scene_of({{0, 0, 1}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
}

TEST(neighbours, of_an_open_fan_know_its_tip_only) {
    const Scene scene = pyramid();
    const Adjacency adjacency = make_adjacency(scene);
    const std::vector<std::uint32_t> away = facing_away(scene, {0, 0, -1});
    ASSERT_THAT(away, ElementsAre(0b1111u));
    for (const Across across : {Across::facing, Across::sides})
        for (const Neighbours& each : neighbours(scene, adjacency, away, across)) {
            EXPECT_EQ(each.away, 0b101u); // across both edges at the tip; none at the border
            EXPECT_EQ(each.inner, 0b001u);
        }
}

TEST(neighbours, one_that_faces_the_light_is_seen_by_all_around_its_corners) {
    Scene scene = pyramid();
    std::swap(scene.triangles[2].y, scene.triangles[2].z); // turned round
    const std::vector<std::uint32_t> away = facing_away(scene, {0, 0, -1});
    ASSERT_THAT(away, ElementsAre(0b1011u));
    const std::vector<Neighbours> found = neighbours(scene, make_adjacency(scene), away);
    for (const Neighbours& each : found) EXPECT_EQ(each.inner, 0u);
    EXPECT_EQ(found[0].away, 0b101u);
    EXPECT_EQ(found[1].away, 0b001u);
    EXPECT_EQ(found[3].away, 0b100u);
}

/// Three triangles that face away at the edge from 0 to 1, the last one of which folds back over the first.
Scene three_at_an_edge(bool last_faces_away) {
    Scene scene =
        scene_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 1, 0}}, {{0, 2, 1}, {0, 1, 3}, {0, 4, 1}});
    if (!last_faces_away) scene.triangles[2] = {0, 1, 4};
    return scene;
}
std::vector<bool> edge_stays(const Scene& scene, Across across) {
    const std::vector<Neighbours> found =
        neighbours(scene, make_adjacency(scene), facing_away(scene, {0, 0, 1}), across);
    return {(found[0].away & 4) != 0, (found[1].away & 1) != 0, (found[2].away & 4) != 0};
}

TEST(neighbours, where_three_meet_all_others_must_face_away_or_one_on_the_other_side) {
    EXPECT_THAT(edge_stays(three_at_an_edge(true), Across::facing), ElementsAre(true, true, true));
    EXPECT_THAT(edge_stays(three_at_an_edge(true), Across::sides), ElementsAre(true, true, true));
    EXPECT_THAT(edge_stays(three_at_an_edge(false), Across::facing), ElementsAre(false, false, false));
    EXPECT_THAT(edge_stays(three_at_an_edge(false), Across::sides), ElementsAre(true, true, false));
}

TEST(neighbours, a_fold_and_a_duplicate_are_no_other_side) {
    Scene scene = three_at_an_edge(true);
    scene.triangles[1] = scene.triangles[0]; // all three on one side now
    EXPECT_THAT(edge_stays(scene, Across::facing), ElementsAre(true, true, true));
    EXPECT_THAT(edge_stays(scene, Across::sides), ElementsAre(false, false, false));
}

} // namespace
} // namespace gnomon
