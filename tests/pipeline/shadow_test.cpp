// Shadows that can be worked out by hand: none on an empty plane, and a floating quad's.
#include "tests/pipeline/geometry.h"
#include "tests/pipeline/scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gnomon::testing {
namespace {

glm::vec3 light_at(double elevation, double azimuth) {
    const double e = glm::radians(elevation), a = glm::radians(azimuth);
    return {std::cos(e) * std::cos(a), -std::sin(e), std::cos(e) * std::sin(a)};
}

void expect_all_lit(const Scene& scene, const View& view, std::size_t least = 500) {
    const auto renderer = make_renderer(scene, view);
    const std::vector<float> truth = visibility(*renderer, raytraced);
    for (const Technique& technique : {nsm, smsr}) {
        const PixelCounts counts =
            count_pixels(renderer->surfaces(), visibility(*renderer, technique), truth);
        EXPECT_GT(counts.facing, least) << technique.name;
        EXPECT_EQ(counts.truly_shadowed, 0u) << technique.name;
        EXPECT_EQ(counts.wrong_shadowed, 0u) << technique.name;
    }
}

TEST(EmptyGround, HasNoShadowUnderAnySun) {
    const Scene scene = ground(6, 4);
    View view = default_view(scene, 80, 60, 128);
    for (const double elevation : {90.0, 75.0, 45.0, 20.0, 7.0, 2.0, 0.5, 0.1})
        for (const double azimuth : {0.0, 37.0, 200.0}) {
            if (elevation == 90 && azimuth != 0) continue;
            SCOPED_TRACE(fmt::format("elevation {}, azimuth {}", elevation, azimuth));
            view.light.direction = light_at(elevation, azimuth);
            expect_all_lit(scene, view);
        }
}

/// The box makes the map see the ground from a low sun with few texels, each of them long.
TEST(EmptyGround, HasNoShadowBesideABoxUnderALowSun) {
    Scene scene = ground(6, 4);
    add_box(scene, {-5.9f, 2, -5.9f}, {-5.8f, 2.1f, -5.8f}); // out of the way of what is seen
    View view = default_view(scene, 80, 60, 128);
    view.camera.position = {3, 2, 4};
    view.camera.direction = {0.1f, -0.5f, -0.5f};
    for (const double elevation : {30.0, 7.0, 2.0, 0.5}) {
        SCOPED_TRACE(elevation);
        view.light.direction = light_at(elevation, 160);
        expect_all_lit(scene, view);
    }
}

TEST(EmptyGround, HasNoShadowUnderALamp) {
    const Scene scene = ground(6, 4);
    View view = default_view(scene, 80, 60, 128);
    for (const glm::vec3 position : {glm::vec3(0, 5, 0), glm::vec3(-4, 2, 1), glm::vec3(-7, 0.5f, 3),
                                     glm::vec3(-8, 0.1f, -2), glm::vec3(1, 40, 3)}) {
        SCOPED_TRACE(fmt::format("lamp at {} {} {}", position.x, position.y, position.z));
        view.light.position = position;
        view.light.direction = glm::vec3(0.3f, -0.2f, 0.1f) - position;
        expect_all_lit(scene, view);
    }
}

TEST(EmptyGround, HasNoShadowInAFineMap) {
    const Scene scene = ground(6);
    View view = default_view(scene, 80, 60, 4096);
    for (const double elevation : {60.0, 1.0}) {
        SCOPED_TRACE(elevation);
        view.light.direction = light_at(elevation, 100);
        expect_all_lit(scene, view);
    }
}

/// Slopes towards the light by every angle: a cylinder of flat faces, open below.
TEST(ConvexHill, ShadowsNothingThatFacesTheLight) {
    Scene scene;
    constexpr int faces = 48;
    const auto rim = [](int i, float z) {
        const double angle = glm::radians(180.0) * i / faces;
        return glm::vec3(3 * std::cos(angle), 3 * std::sin(angle), z);
    };
    for (int i = 0; i < faces; ++i) add_quad(scene, {rim(i, -4), rim(i, 4), rim(i + 1, 4), rim(i + 1, -4)});
    View view = default_view(scene, 160, 120, 256);
    view.camera.position = {0.5f, 11, 1};
    view.camera.direction = {0, -1, -0.1f};
    for (const glm::vec3 direction :
         {glm::vec3(0, -1, 0), glm::vec3(0.5f, -0.7f, 0.3f), glm::vec3(1, -0.1f, 0)}) {
        SCOPED_TRACE(fmt::format("light along {} {} {}", direction.x, direction.y, direction.z));
        view.light.direction = direction;
        expect_all_lit(scene, view);
    }
}

/// Distance of a point from a polygon's border, and whether it lies inside.
struct Placed {
    bool inside;
    double distance;
};
Placed place(const std::array<glm::dvec2, 4>& polygon, glm::dvec2 p) {
    int left = 0, right = 0;
    double distance = 1e300;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % 4];
        const glm::dvec2 ab = b - a, ap = p - a;
        (ab.x * ap.y - ab.y * ap.x > 0 ? left : right)++;
        const double t = std::clamp(glm::dot(ab, ap) / glm::dot(ab, ab), 0.0, 1.0);
        distance = std::min(distance, glm::length(ap - t * ab));
    }
    return {left == 4 || right == 4, distance};
}

constexpr std::array<glm::vec3, 4> quad{glm::vec3(-1.1f, 1.3f, -0.7f), glm::vec3(-0.9f, 1.5f, 0.9f),
                                        glm::vec3(1.2f, 1.6f, 0.8f), glm::vec3(1.0f, 1.4f, -0.8f)};

/// Where a line through a quad's corner, along the light, meets the ground: its shadow is what lies between.
glm::dvec2 shadow_of(glm::dvec3 corner, const View& view) {
    const glm::dvec3 along =
        view.light.position ? corner - glm::dvec3(*view.light.position) : glm::dvec3(view.light.direction);
    const glm::dvec3 foot = corner - corner.y / along.y * along;
    return {foot.x, foot.z};
}

struct QuadCase {
    const char* name;
    View view;
};
std::vector<QuadCase> quad_cases(const Scene& scene) {
    View view = default_view(scene, 280, 210, 128);
    std::vector<QuadCase> cases{{"sun", view}};
    view.light.direction = {0, -1, 0};
    cases.push_back({"zenith", view});
    view.light.direction = {0.9f, -0.4f, -0.2f};
    cases.push_back({"low sun", view});
    view = cases[0].view;
    view.light.position = glm::vec3(-1.5f, 4, 0.6f);
    view.light.direction = {1.5f, -4, -0.6f};
    cases.push_back({"lamp", view});
    view.camera.position = {0.5f, 9, 3}; // and seen from above
    view.camera.direction = {0, -1, -0.2f};
    cases.push_back({"lamp, from above", view});
    return cases;
}

TEST(FloatingQuad, CastsTheShadowOfItsCorners) {
    Scene scene = ground(6);
    add_quad(scene, quad);
    for (const auto& [name, view] : quad_cases(scene)) {
        SCOPED_TRACE(name);
        const auto renderer = make_renderer(scene, view);
        const LightSpace light(view, scene);
        std::array<glm::dvec2, 4> on_ground, in_map;
        for (std::size_t i = 0; i < 4; ++i) {
            on_ground[i] = shadow_of(glm::dvec3(quad[i]), view);
            in_map[i] = glm::dvec2(light.project(glm::dvec3(quad[i])));
        }
        const std::vector<float> truth = visibility(*renderer, raytraced);
        const std::vector<float> plain = visibility(*renderer, nsm), straight = visibility(*renderer, smsr);

        int compared = 0, shadowed = 0, centres = 0, cut = 0;
        for (int y = 0; y < view.settings.height; ++y)
            for (int x = 0; x < view.settings.width; ++x) {
                const Ray ray = camera_ray(view, x, y);
                const Hit hit = first_hit(scene, ray, view.camera.near, view.camera.far);
                if (hit.unsure || hit.triangle < 0 || hit.triangle > 1) continue; // the ground only
                const auto i = static_cast<std::size_t>(y * view.settings.width + x);
                const glm::dvec3 point = ray.at(hit.t);
                const Placed there = place(on_ground, {point.x, point.z});
                ++compared;
                shadowed += there.inside ? 1 : 0;
                if (there.distance > 1e-3) ASSERT_EQ(truth[i] == 0, there.inside) << x << ' ' << y;

                const glm::dvec2 texels(light.project(point));
                const auto beyond = [side = view.settings.shadow_map](double v) {
                    return v < 0 || v >= side;
                };
                if (beyond(texels.x) || beyond(texels.y)) {
                    ASSERT_EQ(plain[i], 1.0f) << x << ' ' << y;
                    continue;
                }
                // Plain shadow mapping answers for the texel's centre, exactly.
                const glm::dvec2 within = texels - glm::floor(texels);
                const bool at_a_grid_line = std::min({within.x, within.y, 1 - within.x, 1 - within.y}) < 1e-3;
                const Placed centre = place(in_map, glm::floor(texels) + 0.5);
                if (!at_a_grid_line && centre.distance > 0.02) {
                    ++centres;
                    ASSERT_EQ(plain[i] == 0, centre.inside) << x << ' ' << y;
                }
                // SMSR cuts lit texels beside shadowed ones, no further.
                const Placed pixel = place(in_map, texels);
                ASSERT_TRUE(straight[i] == 0 || plain[i] == 1) << x << ' ' << y;
                if (straight[i] == 0 && plain[i] == 1) {
                    ++cut;
                    ASSERT_LT(pixel.distance, 1.75) << x << ' ' << y;
                }
            }
        EXPECT_GT(compared, 3000);
        EXPECT_GT(shadowed, 100);
        EXPECT_GT(centres, 3000);
        EXPECT_GT(cut, 10);
    }
}

Scene square_above_ground(float height) {
    Scene scene = ground(6);
    add_quad(scene, {glm::vec3(-1.5f, height, -1.5f), glm::vec3(-1.5f, height, 1.5f),
                     glm::vec3(1.5f, height, 1.5f), glm::vec3(1.5f, height, -1.5f)});
    return scene;
}

struct Shadowed {
    std::size_t truly, found;
};
Shadowed count_shadowed(const Scene& scene, const View& view) {
    const auto renderer = make_renderer(scene, view);
    const PixelCounts counts =
        count_pixels(renderer->surfaces(), visibility(*renderer, nsm), visibility(*renderer, raytraced));
    return {counts.truly_shadowed, counts.truly_shadowed - counts.wrong_lit + counts.wrong_shadowed};
}

TEST(Bias, IsADistanceAlongTheLight) {
    const Scene scene = square_above_ground(1);
    View view = default_view(scene, 160, 120, 256);
    view.light.direction = {0.8f, -1, 0};
    const float apart = glm::length(view.light.direction); // of square and ground, along the light
    for (const bool lamp : {false, true}) {
        SCOPED_TRACE(lamp ? "lamp" : "sun");
        if (lamp) view.light.position = glm::vec3(0, 1, 0) - 20.0f * view.light.direction;
        view.settings.bias = 0.8f * apart;
        const Shadowed within = count_shadowed(scene, view);
        EXPECT_GT(within.truly, 150u);
        EXPECT_NEAR(static_cast<double>(within.found), static_cast<double>(within.truly), 40);
        view.settings.bias = 1.25f * apart;
        EXPECT_EQ(count_shadowed(scene, view).found, 0u);
    }
}

/// Left to the program, the bias loses no shadow that is worth a few texels.
TEST(Bias, IsSmallByDefault) {
    const Scene scene = square_above_ground(0.05f);
    View view = default_view(scene, 160, 120, 2048);
    view.light.direction = {0.8f, -1, 0};
    view.camera.position = {3, 1, 0}; // above the strip of shadow beside the square
    view.camera.direction = {-1.5f, -1, 0};
    view.camera.fov = 10;
    view.camera.near = 0.1f;
    for (const bool lamp : {false, true}) {
        if (lamp) view.light.position = -4.0f * view.light.direction;
        const Shadowed shadowed = count_shadowed(scene, view);
        EXPECT_GT(shadowed.truly, 300u);
        EXPECT_GT(shadowed.found, shadowed.truly * 3 / 4);
        EXPECT_LT(shadowed.found, shadowed.truly * 5 / 4);
    }
}

} // namespace
} // namespace gnomon::testing
