// G-buffer, receivers and shadow map against rays in double precision.
#include "casegen/capture.h"
#include "tests/pipeline/geometry.h"
#include "tests/pipeline/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gnomon::testing {
namespace {

struct Named {
    const char* name;
    View view;
};

/// Over box_on_ground.
std::vector<Named> views() {
    const Scene scene = box_on_ground();
    const View common = default_view(scene, 96, 72, 64);
    std::vector<Named> all{{"directional", common}};

    View view = common;
    view.light.direction = {0, -1, 0};
    all.push_back({"straight down", view});
    view.light.direction = {-40, -1, 25};
    all.push_back({"grazing", view});
    view = common;
    view.light.position = glm::vec3(-3, 5, 2);
    view.light.direction = {3, -5, -2};
    all.push_back({"lamp", view});
    view.light.fov = 35;
    view.light.direction = {3.5f, -4, -2};
    all.push_back({"narrow lamp", view});
    view = common;
    view.camera.position = {0.5f, 3, 0.3f};
    view.camera.direction = {0, -1, 0};
    view.camera.near = 0.01f;
    view.camera.far = 20;
    view.camera.fov = 70;
    all.push_back({"camera straight down", view});
    return all;
}

void expect_near(glm::dvec3 got, glm::dvec3 want, double tolerance, const char* what) {
    EXPECT_NEAR(got.x, want.x, tolerance) << what;
    EXPECT_NEAR(got.y, want.y, tolerance) << what;
    EXPECT_NEAR(got.z, want.z, tolerance) << what;
}

/// The depth, or its reciprocal distance, that the pixel's plane has one texel further.
double plane_value(const LightSpace& light, const View& view, glm::dvec3 point, glm::dvec3 normal,
                   glm::dvec2 texels) {
    const Ray ray = light.ray(texels);
    const glm::dvec3 there = ray.at(glm::dot(normal, point - ray.origin) / glm::dot(normal, ray.direction));
    if (!view.light.position) return light.project(there).z;
    return 1 / glm::dot(glm::normalize(glm::dvec3(view.light.direction)),
                        there - glm::dvec3(*view.light.position));
}

TEST(Projection, ReceiversAreWhereRaysFindThem) {
    const Scene scene = box_on_ground();
    for (const auto& [name, view] : views()) {
        SCOPED_TRACE(name);
        const auto renderer = make_renderer(scene, view);
        const LightSpace light(view, scene);
        const glm::dvec3 eye(view.camera.position);
        int covered = 0, facing = 0, compared = 0;
        for (int y = 0; y < view.settings.height; ++y)
            for (int x = 0; x < view.settings.width; ++x) {
                const auto i = static_cast<std::size_t>(y * view.settings.width + x);
                const shared::Receiver& receiver = renderer->receivers()[i];
                const Ray ray = camera_ray(view, x, y);
                const Hit hit = first_hit(scene, ray, view.camera.near, view.camera.far, 0.02);
                if (hit.unsure) continue;
                ++compared;
                ASSERT_EQ(receiver.map.w >= 0, hit.triangle >= 0) << x << ' ' << y;
                ASSERT_EQ(renderer->surfaces().covered[i] != 0, hit.triangle >= 0) << x << ' ' << y;
                if (hit.triangle < 0) continue;
                ++covered;
                const glm::dvec3 point = ray.at(hit.t);
                const glm::dvec3 normal = normal_towards(scene, hit.triangle, eye, point);
                const double towards = glm::dot(normal, light.to_light(point));
                if (std::abs(towards) > 1e-4) {
                    ASSERT_EQ(receiver.map.w == 1, towards > 0) << x << ' ' << y;
                    ASSERT_EQ(renderer->surfaces().facing[i] != 0, towards > 0) << x << ' ' << y;
                }
                expect_near(glm::dvec3(receiver.origin), point + 1e-5 * scene.bounds().diagonal() * normal,
                            2e-5, "origin of the shadow ray");
                if (towards < 0.01) continue;
                const glm::dvec3 map = light.project(point);
                const double side = view.settings.shadow_map;
                const double within = std::min({map.x, map.y, side - map.x, side - map.y});
                if (within < 0) {
                    if (within < -1e-3)
                        EXPECT_TRUE(receiver.map.x < 0 || receiver.map.y < 0 || receiver.map.x >= side ||
                                    receiver.map.y >= side);
                    continue;
                }
                ++facing;
                const double value =
                    view.light.position ? plane_value(light, view, point, normal, glm::dvec2(map)) : map.z;
                expect_near({receiver.map.x, receiver.map.y, receiver.map.z}, {map.x, map.y, value}, 5e-4,
                            "place in the map");
                for (const glm::dvec2 step : {glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
                    const double there = plane_value(light, view, point, normal, glm::dvec2(map) + step);
                    EXPECT_NEAR(glm::dot(glm::dvec2(receiver.slope), step), there - value, 1e-5);
                }
            }
        EXPECT_GT(compared, view.settings.width * view.settings.height / 2);
        EXPECT_GT(covered, 500);
        EXPECT_GT(facing, 150);
    }
}

TEST(Projection, TheShadowMapHoldsTheNearestSurfaceOfEveryTexel) {
    const Scene scene = box_on_ground();
    for (const auto& [name, view] : views()) {
        SCOPED_TRACE(name);
        const auto renderer = make_renderer(scene, view);
        const LightSpace light(view, scene);
        const std::vector<float> depths = renderer->shadow_map();
        const int side = view.settings.shadow_map;
        ASSERT_EQ(depths.size(), static_cast<std::size_t>(side * side));
        int compared = 0, empty = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Hit hit = first_hit(scene, light.ray({x + 0.5, y + 0.5}), 0, 1, 0.03);
                if (hit.unsure) continue;
                ++compared;
                empty += hit.triangle < 0 ? 1 : 0;
                const float depth = depths[static_cast<std::size_t>(y * side + x)];
                EXPECT_NEAR(static_cast<double>(depth), hit.t, 1e-5) << x << ' ' << y;
            }
        EXPECT_GT(compared, side * side * 2 / 3);
        EXPECT_LT(empty, compared);
    }
}

TEST(Projection, TheMapOfADirectionalLightCoversWhatTheCameraSees) {
    const Scene scene = box_on_ground();
    View view = default_view(scene, 96, 72, 64);
    view.camera.position = {3, 1, 4};
    view.camera.direction = {0.2f, -0.4f, -1};
    for (const glm::vec3 direction :
         {glm::vec3(0.5f, -0.7f, 0.3f), glm::vec3(-1, -0.2f, 0), glm::vec3(0, -1, 0)}) {
        view.light.direction = direction;
        const auto renderer = make_renderer(scene, view);
        std::size_t facing = 0;
        for (const std::uint8_t f : renderer->surfaces().facing) facing += f;
        EXPECT_GT(facing, 1000u);
        EXPECT_EQ(asked_pixels(*renderer).size(), facing);
    }
}

/// Behind a lamp is not in its map, though dividing by the distance would mirror it there.
TEST(Projection, WhatLiesBehindALampIsNotInItsMap) {
    const Scene scene = [] {
        Scene both = ground(6);
        add_quad(both, {glm::vec3(1, 0, -1), glm::vec3(1, 2, -1), glm::vec3(1, 2, 1), glm::vec3(1, 0, 1)});
        return both;
    }();
    View view = default_view(scene, 96, 72, 64);
    view.light.position = glm::vec3(0, 1, 0);
    view.light.direction = {1, -0.2f, 0};
    const auto renderer = make_renderer(scene, view);
    for (const Technique& technique : {nsm, smsr}) {
        const std::vector<float> v = visibility(*renderer, technique);
        int behind = 0;
        for (int y = 0; y < view.settings.height; ++y)
            for (int x = 0; x < view.settings.width; ++x) {
                const Ray ray = camera_ray(view, x, y);
                const Hit hit = first_hit(scene, ray, view.camera.near, view.camera.far);
                if (hit.triangle < 0 || hit.unsure || ray.at(hit.t).x > -0.5) continue;
                ++behind;
                ASSERT_EQ(v[static_cast<std::size_t>(y * view.settings.width + x)], 1.0f) << x << ' ' << y;
            }
        EXPECT_GT(behind, 300);
    }
}

} // namespace
} // namespace gnomon::testing
