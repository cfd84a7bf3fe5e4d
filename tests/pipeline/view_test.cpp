// What cannot be a camera, a light or an image, and what is unusual but can.
#include "casegen/demo_scene.h"
#include "tests/pipeline/geometry.h"
#include "tests/pipeline/scenes.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace gnomon::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

TEST(RequireValid, NamesTheOptionThatIsWrong) {
    struct Wrong {
        const char* option;
        const char* value;
        std::function<void(View&)> set;
    };
    const std::vector<Wrong> all{
        {"--size: the width", "0", [](View& v) { v.settings.width = 0; }},
        {"--size: the height", "-3", [](View& v) { v.settings.height = -3; }},
        {"--size: the width", "16385", [](View& v) { v.settings.width = 16385; }},
        {"--shadow-map", "0", [](View& v) { v.settings.shadow_map = 0; }},
        {"--shadow-map", "16385", [](View& v) { v.settings.shadow_map = 16385; }},
        {"--shadow-map", "1000000000", [](View& v) { v.settings.shadow_map = 1000000000; }},
        {"--camera-direction", "0,0,0", [](View& v) { v.camera.direction = glm::vec3(0); }},
        {"--camera-direction", "nan,0,0",
         [](View& v) {
             v.camera.direction = {nan, 0, 0};
         }},
        {"--camera-direction", "0,inf,0",
         [](View& v) {
             v.camera.direction = {0, infinite, 0};
         }},
        {"--camera-position", "0,nan,0",
         [](View& v) {
             v.camera.position = {0, nan, 0};
         }},
        {"--light-direction", "0,0,0", [](View& v) { v.light.direction = glm::vec3(0); }},
        {"--light-direction", "0,0,nan",
         [](View& v) {
             v.light.direction = {0, 0, nan};
         }},
        {"--light-position", "inf,0,0", [](View& v) { v.light.position = glm::vec3(infinite, 0, 0); }},
        {"--fov", "0;", [](View& v) { v.camera.fov = 0; }},
        {"--fov", "180", [](View& v) { v.camera.fov = 180; }},
        {"--fov", "-10", [](View& v) { v.camera.fov = -10; }},
        {"--fov", "nan", [](View& v) { v.camera.fov = nan; }},
        {"--light-fov", "200", [](View& v) { v.light.fov = 200; }},
        {"--near", "0", [](View& v) { v.camera.near = 0; }},
        {"--near", "-1", [](View& v) { v.camera.near = -1; }},
        {"--near", "nan", [](View& v) { v.camera.near = nan; }},
        {"--near is 5 and --far", "5", [](View& v) { v.camera.near = v.camera.far = 5; }},
        {"--near is 5 and --far", "1", [](View& v) { v.camera.near = 5, v.camera.far = 1; }},
        {"--near is 0.1 and --far", "inf", [](View& v) { v.camera.far = infinite; }},
        {"--near is 0.1 and --far", "nan", [](View& v) { v.camera.far = nan; }},
        {"--bias", "-0.5", [](View& v) { v.settings.bias = -0.5f; }},
        {"--bias", "nan", [](View& v) { v.settings.bias = nan; }},
        {"--bias", "inf", [](View& v) { v.settings.bias = infinite; }},
    };
    for (const Wrong& wrong : all) {
        View view;
        require_valid(view.camera, view.light, view.settings);
        wrong.set(view);
        const std::string expected = fmt::format("{} is {}", wrong.option, wrong.value);
        EXPECT_THAT(error_of([&] { require_valid(view.camera, view.light, view.settings); }),
                    StartsWith(expected));
        // And nobody gets past it.
        EXPECT_THAT(error_of([&] {
                        make_frame(view.camera, view.light, view.settings, Box{glm::vec3(-1), glm::vec3(1)});
                    }),
                    StartsWith(expected));
    }
}

TEST(RequireValid, TakesTheExtremes) {
    View view;
    view.settings.width = view.settings.height = view.settings.shadow_map = 16384;
    view.camera.fov = 179;
    view.light.fov = 0.1f;
    view.camera.direction = {1e-30f, 0, 0}; // its square is not a float
    view.light.direction = {0, -1e30f, 1e30f};
    EXPECT_NO_THROW(require_valid(view.camera, view.light, view.settings));
}

TEST(MakeFrame, TakesDirectionsOfAnyLength) {
    const Box box{glm::vec3(-1), glm::vec3(1)};
    View view = default_view(box_on_ground(), 64, 48, 64);
    view.light.direction = {1, -2, 0.5f};
    const shared::Frame want = make_frame(view.camera, view.light, view.settings, box);
    for (const float length : {1e-30f, 1e-3f, 1e4f, 1e30f}) {
        view.light.direction = length * glm::vec3(1, -2, 0.5f);
        const shared::Frame got = make_frame(view.camera, view.light, view.settings, box);
        EXPECT_LT(glm::length(got.light_origin - want.light_origin), 1e-6f) << length;
    }
}

TEST(MakeFrame, RefusesALampThatLooksAway) {
    View view = default_view(box_on_ground(), 64, 48, 64);
    view.light.position = glm::vec3(0, 30, 0);
    view.light.direction = {0, 1, 0};
    EXPECT_THAT(
        error_of([&] { make_frame(view.camera, view.light, view.settings, box_on_ground().bounds()); }),
        HasSubstr("--light-position"));
}

TEST(MakeFrame, RefusesScenesThatSinglePrecisionCannotHold) {
    for (const float factor : {1e-9f, 1e7f}) {
        const Scene scene = scaled(box_on_ground(), factor);
        const View view = default_view(scene, 64, 48, 64);
        EXPECT_THAT(error_of([&] { make_frame(view.camera, view.light, view.settings, scene.bounds()); }),
                    HasSubstr("scale it"));
    }
}

struct Judged {
    PixelCounts nsm, smsr;
};

Judged judge(const Scene& scene, const View& view) {
    const auto renderer = make_renderer(scene, view);
    const std::vector<float> truth = visibility(*renderer, raytraced);
    for (const float v : truth) EXPECT_TRUE(v == 0 || v == 1);
    return {count_pixels(renderer->surfaces(), visibility(*renderer, nsm), truth),
            count_pixels(renderer->surfaces(), visibility(*renderer, smsr), truth)};
}

TEST(Views, LightAlongEveryAxis) {
    const Scene scene = box_on_ground();
    View view = default_view(scene, 120, 90, 512);
    for (const glm::vec3 direction :
         {glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0),
          glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1e-4f, -1, 0), glm::vec3(0, -1, 0.04f)}) {
        SCOPED_TRACE(fmt::format("{} {} {}", direction.x, direction.y, direction.z));
        view.light.direction = direction;
        view.light.position.reset();
        const Judged sun = judge(scene, view);
        EXPECT_GT(sun.nsm.covered, 2000u);
        EXPECT_LE(sun.nsm.wrong_share(), 0.01);
        view.light.position = -8.0f * direction + glm::vec3(0, 0.3f, 0);
        const Judged lamp = judge(scene, view);
        EXPECT_EQ(lamp.nsm.covered, sun.nsm.covered);
        EXPECT_LE(lamp.nsm.wrong_share(), 0.02);
    }
}

TEST(Views, CameraAlongTheVertical) {
    const Scene scene = box_on_ground();
    View view = default_view(scene, 120, 90, 512);
    view.camera.position = {0, 10, 0};
    for (const glm::vec3 direction :
         {glm::vec3(0, -1, 0), glm::vec3(1e-4f, -1, 0), glm::vec3(0.05f, -1, 0)}) {
        view.camera.direction = direction;
        const Judged judged = judge(scene, view);
        EXPECT_GT(judged.nsm.covered, 9000u);
        EXPECT_GT(judged.nsm.truly_shadowed, 100u);
        EXPECT_LT(judged.nsm.wrong_share(), 0.01);
    }
    view.camera.position = {0, -10, 0}; // from below: its underside, which the sun does not reach
    view.camera.direction = {0, 1, 0};
    const Judged below = judge(scene, view);
    EXPECT_GT(below.nsm.covered, 9000u);
    EXPECT_EQ(below.nsm.facing, 0u);
}

TEST(Views, AFlatSceneAndOneTriangle) {
    Scene triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    triangle.normals.assign(3, {0, 1, 0});
    triangle.triangles = {{0, 1, 2}};
    Scene wall;
    add_quad(wall, {glm::vec3(0, 0, 2), glm::vec3(3, 0, 2), glm::vec3(3, 1, 2), glm::vec3(0, 1, 2)});
    for (const Scene& scene : {triangle, wall, ground(1)}) {
        View view = default_view(scene, 64, 48, 64);
        view.light.direction = {0.1f, -0.7f, -0.5f};
        for (const bool lamp : {false, true}) {
            if (lamp) view.light.position = scene.bounds().centre() - 3.0f * view.light.direction;
            const Judged judged = judge(scene, view);
            EXPECT_GT(judged.nsm.facing, 100u);
            EXPECT_EQ(judged.nsm.truly_shadowed, 0u);
            EXPECT_EQ(judged.nsm.wrong_shadowed, 0u);
            EXPECT_EQ(judged.smsr.wrong_shadowed, 0u);
        }
    }
}

/// Only rounding may tell a scene's unit of length.
TEST(Views, ScenesOfEverySizeLookTheSame) {
    const Scene unit = demo_scene();
    for (const bool lamp : {false, true}) {
        const View view = lamp ? demo_view_with_lamp(160, 120, 256) : demo_view(160, 120, 256);
        const Judged want = judge(unit, view);
        for (const float factor : {1e-5f, 0.01f, 100.0f, 1e5f}) {
            SCOPED_TRACE(fmt::format("{}, times {}", lamp ? "lamp" : "sun", factor));
            View there = view;
            there.camera.position *= factor;
            there.camera.near *= factor;
            there.camera.far *= factor;
            if (lamp) *there.light.position *= factor;
            const Judged got = judge(scaled(unit, factor), there);
            const auto about = [](std::size_t a, std::size_t b) {
                EXPECT_NEAR(static_cast<double>(a), static_cast<double>(b), 30);
            };
            about(got.nsm.covered, want.nsm.covered);
            about(got.nsm.facing, want.nsm.facing);
            about(got.nsm.truly_shadowed, want.nsm.truly_shadowed);
            about(got.nsm.wrong_lit, want.nsm.wrong_lit);
            about(got.nsm.wrong_shadowed, want.nsm.wrong_shadowed);
            about(got.smsr.wrong_lit, want.smsr.wrong_lit);
            about(got.smsr.wrong_shadowed, want.smsr.wrong_shadowed);
        }
    }
}

TEST(Views, DefaultCameraSeesTheWholeScene) {
    for (const float factor : {1e-4f, 1.0f, 1e5f})
        for (const auto& [width, height] :
             {std::pair(80, 60), std::pair(60, 60), std::pair(30, 90), std::pair(200, 20)})
            for (const Scene& scene : {scaled(demo_scene(), factor), scaled(box_on_ground(), factor)}) {
                const View view = default_view(scene, width, height, 64);
                const shared::Frame frame =
                    make_frame(view.camera, view.light, view.settings, scene.bounds());
                for (const glm::vec3 position : scene.positions) {
                    const glm::vec4 clip = frame.camera * glm::vec4(position, 1);
                    ASSERT_LE(std::abs(clip.x), clip.w);
                    ASSERT_LE(std::abs(clip.y), clip.w);
                    ASSERT_GE(clip.z, 0);
                    ASSERT_LE(clip.z, clip.w);
                }
            }
}

TEST(Views, InsideAClosedBoxAllIsDark) {
    Scene scene;
    add_box(scene, glm::vec3(-2), glm::vec3(2));
    View view = default_view(scene, 120, 90, 256);
    view.camera.position = {0.3f, 0.2f, 0.1f};
    view.camera.fov = 100;
    view.camera.near = 0.01f;
    for (const glm::vec3 direction : {glm::vec3(0.5f, -0.7f, 0.3f), glm::vec3(-1, 0.2f, 0.1f)}) {
        view.camera.direction = direction;
        const Judged judged = judge(scene, view);
        EXPECT_EQ(judged.nsm.covered, judged.nsm.all);
        EXPECT_EQ(judged.nsm.truly_lit, 0u);
        // Where two walls meet, the texel of one may hold the other.
        EXPECT_LT(judged.nsm.wrong_share(), 0.02);
        EXPECT_LT(judged.smsr.wrong_share(), 0.02);
    }
}

TEST(Views, SeeingNothingCountsNothing) {
    const Scene scene = box_on_ground();
    View view = default_view(scene, 40, 30, 64);
    view.camera.direction = -view.camera.direction;
    const auto renderer = make_renderer(scene, view);
    const std::vector<float> truth = visibility(*renderer, raytraced);
    for (const Technique& technique : {no_shadows, nsm, smsr, raytraced}) {
        const Rendering rendering = renderer->render(technique, 1);
        const PixelCounts counts = count_pixels(renderer->surfaces(), rendering.visibility, truth);
        EXPECT_EQ(counts.all, 1200u);
        EXPECT_EQ(counts.covered, 0u);
        EXPECT_EQ(counts.wrong_share(), 0);
        for (const Rgb& pixel : rendering.image.pixels) ASSERT_EQ(pixel, rendering.image.pixels[0]);
    }
}

TEST(Views, ImagesOfOnePixelAndOneTexel) {
    const Scene scene = box_on_ground();
    for (const auto& [width, height, side] :
         {std::tuple(1, 1, 1), std::tuple(1, 97, 1), std::tuple(131, 1, 3)}) {
        View view = default_view(scene, 80, 60, side);
        view.settings.width = width;
        view.settings.height = height;
        const Judged judged = judge(scene, view);
        EXPECT_EQ(judged.nsm.all, static_cast<std::size_t>(width * height));
        EXPECT_GT(judged.nsm.covered, 0u);
    }
}

} // namespace
} // namespace gnomon::testing
