#include "runtime/rays.h"

#include "casegen/demo_scene.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <tbb/global_control.h>

namespace gnomon {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using testing::Random;

enum class Truth { visible, occluded, too_close_to_call };

/// What a ray in double precision finds in one triangle (Möller and Trumbore). A hit so near an edge or an
/// end of the segment that single precision may decide otherwise is too close to call.
Truth meets(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
            const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    constexpr double barycentric_margin = 1e-3, distance_margin = 1e-4;
    const glm::dvec3 p = glm::cross(direction, c - a);
    const double determinant = glm::dot(b - a, p);
    if (determinant == 0) return Truth::visible;
    const double u = glm::dot(origin - a, p) / determinant;
    const glm::dvec3 q = glm::cross(origin - a, b - a);
    const double v = glm::dot(direction, q) / determinant;
    const double t = glm::dot(c - a, q) / determinant;
    const double inside = std::min({u, v, 1 - u - v});
    const double within = std::min(t - begin, end - t);
    if (inside > barycentric_margin && within > distance_margin) return Truth::occluded;
    if (inside < -barycentric_margin || within < -distance_margin) return Truth::visible;
    return Truth::too_close_to_call;
}

Truth trace(const Scene& scene, const glm::dvec3& origin, const glm::dvec3& direction, double begin,
            double end) {
    Truth truth = Truth::visible;
    for (const glm::uvec3 t : scene.triangles) {
        const Truth met = meets(origin, direction, begin, end, glm::dvec3(scene.positions[t.x]),
                                glm::dvec3(scene.positions[t.y]), glm::dvec3(scene.positions[t.z]));
        if (met == Truth::occluded) return met;
        if (met == Truth::too_close_to_call) truth = met;
    }
    return truth;
}

glm::vec3 random_point(Random& random, float half_width) {
    const float x = random.between(-half_width, half_width), y = random.between(-half_width, half_width);
    return {x, y, random.between(-half_width, half_width)};
}

Scene random_soup(std::uint64_t seed, int triangles) {
    Random random(seed);
    Scene scene;
    for (int i = 0; i < triangles; ++i) {
        const glm::vec3 centre = random_point(random, 5.0f);
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        for (int k = 0; k < 3; ++k) scene.positions.push_back(centre + random_point(random, 2.0f));
        scene.triangles.emplace_back(first, first + 1, first + 2);
    }
    return scene;
}

/// Points on the scene's triangles and in the air around them.
std::vector<glm::vec3> random_receivers(const Scene& scene, std::uint64_t seed, std::size_t count) {
    Random random(seed);
    std::vector<glm::vec3> origins;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::uvec3 t =
            scene.triangles[random.below(static_cast<std::uint32_t>(scene.triangles.size()))];
        float u = random.between(0, 1), v = random.between(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const glm::vec3 a = scene.positions[t.x], b = scene.positions[t.y], c = scene.positions[t.z];
        origins.push_back(i % 3 == 0 ? random_point(random, 6.0f) : a + u * (b - a) + v * (c - a));
    }
    return origins;
}

std::vector<std::uint8_t> all_active(std::size_t count) { return std::vector<std::uint8_t>(count, 1); }

/// Compares every receiver that the reference can decide; nearly all must be, and both answers must occur.
template <typename DirectionAndEnd>
void expect_as_reference(const Scene& scene, const std::vector<glm::vec3>& origins, float tmin,
                         const std::vector<std::uint8_t>& visible, const DirectionAndEnd& direction_and_end) {
    ASSERT_EQ(visible.size(), origins.size());
    std::size_t undecided = 0, occluded = 0, wrong = 0;
    for (std::size_t i = 0; i < origins.size(); ++i) {
        const auto [direction, end] = direction_and_end(glm::dvec3(origins[i]));
        const Truth truth = trace(scene, glm::dvec3(origins[i]), direction, static_cast<double>(tmin), end);
        undecided += truth == Truth::too_close_to_call;
        occluded += truth == Truth::occluded;
        wrong += truth != Truth::too_close_to_call && visible[i] != (truth == Truth::visible);
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_LT(undecided, origins.size() / 20);
    EXPECT_GT(occluded, origins.size() / 20);
    EXPECT_LT(occluded, origins.size() * 19 / 20);
}

void expect_both_lights_as_reference(const Scene& scene, std::uint64_t seed, std::size_t count,
                                     const std::string& embree_options = {}) {
    const RayTracer tracer(scene, embree_options);
    const std::vector<glm::vec3> origins = random_receivers(scene, seed, count);
    const std::vector<std::uint8_t> active = all_active(count);
    constexpr float tmin = 0.01f;

    const glm::vec3 towards(3.1f, 4.7f, -2.3f);
    expect_as_reference(
        scene, origins, tmin, tracer.visible_along(origins, active, towards, tmin), [&](const glm::dvec3&) {
            return std::pair(glm::normalize(glm::dvec3(towards)), std::numeric_limits<double>::infinity());
        });
    const glm::vec3 light(1.3f, 3.7f, -0.9f);
    expect_as_reference(scene, origins, tmin, tracer.visible_from(origins, active, light, tmin),
                        [&](const glm::dvec3& origin) {
                            const glm::dvec3 offset = glm::dvec3(light) - origin;
                            return std::pair(glm::normalize(offset), glm::length(offset));
                        });
}

/// A triangle around the z axis at this height, its face up or down.
void add_triangle_at(Scene& scene, float z, bool face_up = true) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const glm::vec2 p : {glm::vec2(-1, -1), glm::vec2(2, -1), glm::vec2(-1, 2)})
        scene.positions.emplace_back(p.x, p.y, z);
    scene.triangles.emplace_back(first, face_up ? first + 1 : first + 2, face_up ? first + 2 : first + 1);
}

const std::vector<glm::vec3> at_origin{glm::vec3(0.0f)};
const std::vector<std::uint8_t> one_active{1};

TEST(Rays, RandomSoupsAsBruteForce) {
    for (const std::uint64_t seed : {1u, 2u, 3u})
        expect_both_lights_as_reference(random_soup(seed, 60), seed, 3000);
    expect_both_lights_as_reference(random_soup(4, 400), 4, 1501);
}

TEST(Rays, DemoSceneAsBruteForce) { expect_both_lights_as_reference(demo_scene(), 5, 3000); }

TEST(Rays, OlderProcessorsAsBruteForce) {
    for (const char* options : {"isa=sse2", "isa=sse4.2", "isa=avx", "isa=avx2"})
        expect_both_lights_as_reference(random_soup(6, 60), 6, 3001, options);
}

TEST(Rays, HitsNearerThanTminAreIgnoredInWorldUnits) {
    Scene scene;
    add_triangle_at(scene, 0.5f);
    const RayTracer tracer(scene);
    for (const float length : {0.01f, 1.0f, 300.0f}) {
        const glm::vec3 up(0, 0, length);
        EXPECT_EQ(tracer.visible_along(at_origin, one_active, up, 0.45f)[0], 0);
        EXPECT_EQ(tracer.visible_along(at_origin, one_active, up, 0.55f)[0], 1);
        EXPECT_EQ(tracer.visible_along(at_origin, one_active, -up, 0.45f)[0], 1);
    }
    for (const float distance : {1.0f, 300.0f}) {
        EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, distance}, 0.45f)[0], 0);
        EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, distance}, 0.55f)[0], 1);
    }
}

TEST(Rays, DirectionalLightIsUnbounded) {
    Scene scene;
    add_triangle_at(scene, 1e6f);
    EXPECT_EQ(RayTracer(scene).visible_along(at_origin, one_active, {0, 0, 1}, 1e-3f)[0], 0);
}

TEST(Rays, PointLightStopsAtTheLight) {
    Scene scene;
    add_triangle_at(scene, 2.0f);
    const RayTracer tracer(scene);
    EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, 1.999f}, 1e-3f)[0], 1);
    EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, 2.001f}, 1e-3f)[0], 0);
    EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, -5}, 1e-3f)[0], 1);
    EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, 0}, 1e-3f)[0],
              1); // the light is the receiver
    EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, 5e-4f}, 1e-3f)[0], 1);
}

TEST(Rays, BothFacesOccludeWhateverTheWinding) {
    for (const bool face_up : {false, true}) {
        Scene scene;
        add_triangle_at(scene, 1.0f, face_up);
        EXPECT_EQ(RayTracer(scene).visible_along(at_origin, one_active, {0, 0, 1}, 1e-3f)[0], 0);
    }
}

TEST(Rays, NoLightPassesBetweenNeighbours) {
    // A bumpy sheet, far from the origin; every ray is aimed at an edge or a corner that triangles share.
    constexpr std::uint32_t side = 40;
    Scene scene;
    Random random(7);
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t x = 0; x < side; ++x)
            scene.positions.emplace_back(120.0f + static_cast<float>(x) * 0.37f, random.between(0.0f, 0.5f),
                                         -310.0f + static_cast<float>(z) * 0.41f);
    for (std::uint32_t z = 0; z + 1 < side; ++z)
        for (std::uint32_t x = 0; x + 1 < side; ++x) {
            const std::uint32_t i = z * side + x;
            scene.triangles.emplace_back(i, i + side, i + 1);
            scene.triangles.emplace_back(i + 1, i + side, i + side + 1);
        }
    const glm::vec3 towards = glm::normalize(glm::vec3(0.31f, 0.87f, 0.17f)), light(127.0f, 40.0f, -300.0f);
    std::vector<glm::vec3> below, below_light;
    for (int i = 0; i < 100000; ++i) {
        const std::uint32_t corner = (5 + random.below(side - 10)) * side + 5 + random.below(side - 10);
        const glm::vec3 a = scene.positions[corner];
        const std::uint32_t neighbours[] = {corner, corner + 1, corner + side, corner + side - 1};
        const glm::vec3 b = scene.positions[neighbours[random.below(4)]];
        const glm::vec3 aim = glm::mix(a, b, random.between(0.0f, 1.0f));
        below.push_back(aim - random.between(1.0f, 9.0f) * towards);
        below_light.push_back(aim + random.between(0.1f, 0.5f) * (aim - light));
    }
    const RayTracer tracer(scene);
    const std::vector<std::uint8_t> active = all_active(below.size());
    const auto along = tracer.visible_along(below, active, towards, 1e-3f);
    const auto from = tracer.visible_from(below_light, active, light, 1e-3f);
    EXPECT_EQ(std::ranges::count(along, 1), 0);
    EXPECT_EQ(std::ranges::count(from, 1), 0);
}

TEST(Rays, InactiveReceiversAreSkippedAndVisible) {
    Scene scene;
    add_triangle_at(scene, 1.0f);
    const RayTracer tracer(scene);
    for (const std::size_t count : {0u, 1u, 15u, 16u, 17u, 33u, 5000u}) {
        std::vector<glm::vec3> origins(count, glm::vec3(0.0f));
        std::vector<std::uint8_t> active(count);
        Random random(count);
        for (std::size_t i = 0; i < count; ++i) {
            active[i] = static_cast<std::uint8_t>(random.below(3)); // 2 is active, too
            if (active[i] == 0) origins[i].x = std::numeric_limits<float>::quiet_NaN();
        }
        const auto along = tracer.visible_along(origins, active, {0, 0, 1}, 1e-3f);
        const auto from = tracer.visible_from(origins, active, {0, 0, 3}, 1e-3f);
        ASSERT_EQ(along.size(), count);
        ASSERT_EQ(from.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(along[i], active[i] == 0) << i << " of " << count;
            ASSERT_EQ(from[i], active[i] == 0) << i << " of " << count;
        }
    }
}

TEST(Rays, OneThreadFindsTheSame) {
    const Scene scene = demo_scene();
    const std::vector<glm::vec3> origins = random_receivers(scene, 8, 50007);
    const std::vector<std::uint8_t> active = all_active(origins.size());
    const auto trace_all = [&] {
        const RayTracer tracer(scene);
        auto visible = tracer.visible_along(origins, active, {1, 2, 0.5f}, 1e-3f);
        const auto from = tracer.visible_from(origins, active, {3, 4, -2}, 1e-3f);
        visible.insert(visible.end(), from.begin(), from.end());
        return visible;
    };
    const auto on_all_cores = trace_all();
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(trace_all(), on_all_cores);
}

TEST(Rays, EmptySceneOccludesNothing) {
    const RayTracer tracer{Scene()};
    EXPECT_EQ(tracer.visible_along(at_origin, one_active, {0, 0, 1}, 1e-3f)[0], 1);
    EXPECT_EQ(tracer.visible_from(at_origin, one_active, {0, 0, 1}, 1e-3f)[0], 1);
}

TEST(Rays, TheSceneMayGoAndTheTracerMayMove) {
    RayTracer kept{Scene()};
    {
        Scene scene;
        add_triangle_at(scene, 1.0f);
        RayTracer tracer(scene);
        kept = std::move(tracer);
    }
    const RayTracer moved = std::move(kept);
    EXPECT_EQ(moved.visible_along(at_origin, one_active, {0, 0, 1}, 1e-3f)[0], 0);
}

TEST(Rays, UselessArgumentsAreErrors) {
    const RayTracer tracer{Scene()};
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float tmin : {0.0f, -1.0f, nan, std::numeric_limits<float>::infinity()}) {
        EXPECT_THAT(error_of([&] {
                        tracer.visible_along(at_origin, one_active, {0, 0, 1}, tmin);
                    }),
                    HasSubstr("tmin"));
        EXPECT_THAT(error_of([&] {
                        tracer.visible_from(at_origin, one_active, {0, 0, 1}, tmin);
                    }),
                    HasSubstr("tmin"));
    }
    for (const glm::vec3 bad : {glm::vec3(0.0f), glm::vec3(0, nan, 0)})
        EXPECT_THAT(error_of([&] { tracer.visible_along(at_origin, one_active, bad, 0.1f); }),
                    HasSubstr("direction"));
    EXPECT_THAT(error_of([&] {
                    tracer.visible_from(at_origin, one_active, {nan, 0, 0}, 0.1f);
                }),
                HasSubstr("light"));

    std::vector<glm::vec3> origins(1000, glm::vec3(0.0f));
    origins[777].y = nan;
    EXPECT_THAT(error_of([&] {
                    tracer.visible_along(origins, all_active(1000), {0, 0, 1}, 0.1f);
                }),
                HasSubstr("receiver 777"));
    EXPECT_THROW(tracer.visible_along(origins, one_active, {0, 0, 1}, 0.1f), std::invalid_argument);
}

} // namespace
} // namespace gnomon
