#include "casegen/demo_scene.h"

#include "runtime/files.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>
#include <vector>

namespace gnomon {
namespace {

using Corner = std::tuple<float, float, float>;

Corner corner(glm::vec3 p) { return {p.x, p.y, p.z}; }

/// The first two triangles.
constexpr std::size_t ground_triangles = 2;

/// For each triangle, the number of the closed solid it belongs to: triangles that share a corner are of one.
std::vector<std::size_t> solids(const Scene& scene) {
    std::vector<std::size_t> parent(scene.triangles.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::map<Corner, std::size_t> seen;
    for (std::size_t i = ground_triangles; i < scene.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const auto [at, is_new] = seen.try_emplace(corner(scene.positions[scene.triangles[i][k]]), i);
            if (!is_new) parent[root(i)] = root(at->second);
        }
    for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = root(i);
    return parent;
}

TEST(DemoScene, IsWellFormed) {
    const Scene scene = demo_scene();
    EXPECT_EQ(scene.name, "demo");
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_GT(scene.triangles.size(), 300u);
    EXPECT_LT(scene.triangles.size(), 5000u);
    ASSERT_EQ(scene.positions.size(), scene.normals.size());
    for (const glm::uvec3 t : scene.triangles)
        for (int k = 0; k < 3; ++k) ASSERT_LT(t[k], scene.positions.size());
}

TEST(DemoScene, StandsOnItsGround) {
    const Scene scene = demo_scene();
    const Box box = scene.bounds();
    EXPECT_EQ(box.lower.x, -6.0f);
    EXPECT_EQ(box.upper.x, 6.0f);
    EXPECT_EQ(box.lower.z, -6.0f);
    EXPECT_EQ(box.upper.z, 6.0f);
    EXPECT_GT(box.lower.y, -0.1f);
    EXPECT_GT(box.upper.y, 2.0f);
    EXPECT_LT(box.upper.y, 4.0f);
    // No other face lies in the ground's plane.
    for (std::size_t i = ground_triangles; i < scene.triangles.size(); ++i) {
        const glm::uvec3 t = scene.triangles[i];
        EXPECT_FALSE(scene.positions[t.x].y == 0 && scene.positions[t.y].y == 0 &&
                     scene.positions[t.z].y == 0);
    }
}

TEST(DemoScene, NormalsAreFlatAndOnTheCounterClockwiseSide) {
    const Scene scene = demo_scene();
    for (const glm::uvec3 t : scene.triangles) {
        const glm::vec3 a = scene.positions[t.x], b = scene.positions[t.y], c = scene.positions[t.z];
        const glm::vec3 area = glm::cross(b - a, c - a);
        ASSERT_GT(glm::length(area), 1e-5f);
        for (int k = 0; k < 3; ++k) {
            ASSERT_NEAR(glm::length(scene.normals[t[k]]), 1.0f, 1e-6f);
            ASSERT_GT(glm::dot(scene.normals[t[k]], glm::normalize(area)), 0.9999f);
        }
    }
}

TEST(DemoScene, SolidsAreClosed) {
    const Scene scene = demo_scene();
    std::map<std::pair<Corner, Corner>, int> edges; // once each way
    for (std::size_t i = ground_triangles; i < scene.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k)
            ++edges[{corner(scene.positions[scene.triangles[i][k]]),
                     corner(scene.positions[scene.triangles[i][(k + 1) % 3]])}];
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

TEST(DemoScene, SolidsFaceOutwards) {
    const Scene scene = demo_scene();
    const std::vector<std::size_t> solid = solids(scene);
    std::map<std::size_t, double> volumes;
    for (std::size_t i = ground_triangles; i < scene.triangles.size(); ++i) {
        const glm::uvec3 t = scene.triangles[i];
        // From a corner of the solid itself, so that rounding stays small.
        const glm::dvec3 origin(scene.positions[scene.triangles[solid[i]].x]);
        volumes[solid[i]] += glm::dot(glm::dvec3(scene.positions[t.x]) - origin,
                                      glm::cross(glm::dvec3(scene.positions[t.y]) - origin,
                                                 glm::dvec3(scene.positions[t.z]) - origin)) /
                             6;
    }
    EXPECT_GT(volumes.size(), 60u);
    for (const auto& [number, volume] : volumes) EXPECT_GT(volume, 1e-5) << "solid of triangle " << number;
}

template <typename T>
std::uint64_t hash_of(const std::vector<T>& values, std::uint64_t state) {
    return hash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)}, state);
}

TEST(DemoScene, AlwaysTheSameBits) {
    // Stored results depend on this scene: whoever changes it must mean to.
    const Scene scene = demo_scene();
    std::uint64_t bits = hash("");
    bits = hash_of(scene.positions, bits);
    bits = hash_of(scene.normals, bits);
    bits = hash_of(scene.triangles, bits);
    EXPECT_EQ(bits, 0xc72d15355a269f85ull);
}

} // namespace
} // namespace gnomon
