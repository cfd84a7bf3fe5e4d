// What the thesis's classifiers say of a frame's pixels, and what becomes of it.
#include "casegen/demo_scene.h"
#include "runtime/hybrid/classifier.h"
#include "tests/pipeline/view.h"
#include "tests/support/device.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace gnomon::testing {
namespace {

std::vector<std::string> published_names() {
    std::vector<std::string> names{"beister", "bilinear", "crsm", "crsma-one-ring"};
    if (shared_device().has_geometry_shaders()) names.emplace_back("crsma");
    return names;
}

View published_demo(int shadow_map) {
    View view = demo_view(160, 120, shadow_map);
    view.settings = as_published(160, 120, shadow_map);
    return view;
}

TEST(PublishedStates, CertainPixelsAreWhatTheyAreSaidToBeAndTheOthersTraced) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, published_demo(512));
    const std::vector<float> truth = visibility(*renderer, raytraced);
    const Surfaces& surfaces = renderer->surfaces();
    for (const std::string& name : published_names()) {
        const std::vector<float> found = renderer->visibility(hybrid(name));
        const std::vector<PixelState> states = renderer->states(hybrid(name));
        std::map<PixelState, std::size_t> pixels;
        for (std::size_t i = 0; i < states.size(); ++i) {
            if (surfaces.facing[i] == 0) {
                ASSERT_EQ(states[i], PixelState::shadowed) << name << i;
                ASSERT_EQ(found[i], 0.0f) << name << i;
                continue;
            }
            ++pixels[states[i]];
            if (states[i] == PixelState::uncertain)
                ASSERT_EQ(found[i], truth[i]) << name << i;
            else
                ASSERT_EQ(found[i], states[i] == PixelState::lit ? 1.0f : 0.0f) << name << i;
        }
        EXPECT_GT(pixels[PixelState::lit], 1000u) << name;
        EXPECT_GT(pixels[PixelState::uncertain], 500u) << name;
    }
}

TEST(PublishedStates, EachClassifierIsSurerThanTheLast) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, published_demo(1024));
    const auto uncertain = [&](const char* name) {
        return std::ranges::count(renderer->states(hybrid(name)), PixelState::uncertain);
    };
    EXPECT_LT(uncertain("bilinear"), uncertain("beister"));
    EXPECT_LT(uncertain("crsma-one-ring"), uncertain("crsm"));
    if (!shared_device().has_geometry_shaders())
        GTEST_SKIP() << "this device has no geometry shaders: crsma refuses";
    EXPECT_LT(uncertain("crsma"), uncertain("crsm"));
    EXPECT_LE(uncertain("crsma-one-ring"), uncertain("crsma"));
}

/// A cube of side 2, counter-clockwise as seen from outside.
Scene cube() {
    Scene scene;
    for (int i = 0; i < 8; ++i)
        scene.positions.emplace_back((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    scene.normals.resize(8, glm::vec3(0, 1, 0));
    constexpr unsigned faces[6][4]{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2},
                                   {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
    for (const auto& f : faces) {
        scene.triangles.push_back({f[0], f[1], f[2]});
        scene.triangles.push_back({f[0], f[2], f[3]});
    }
    return scene;
}

TEST(PublishedStates, GeometryStageEmitsOneOneTwoOrFourTriangles) {
    if (!shared_device().has_geometry_shaders())
        GTEST_SKIP() << "this device has no geometry shaders: crsma refuses";
    const Scene scene = cube();
    View view = default_view(scene, 160, 120, 512);
    view.light.direction = {0.4f, -0.6f, 0.5f};
    view.settings = as_published(160, 120, 512);
    const auto renderer = make_renderer(scene, view);
    const auto emitted = [&](const char* name) {
        return renderer->render(hybrid(name), 1).hybrid->maps.triangles_emitted;
    };
    // Three squares face away, which meet in a corner. Each has two edges to another one and a diagonal: its
    // two halves have one and three neighbours that face away, or two each, and become 1 + 4 or 2 + 2
    // triangles.
    const std::size_t small = emitted("crsma") - 12;
    EXPECT_GE(small, 3u * 4);
    EXPECT_LE(small, 3u * 5);
    EXPECT_EQ(emitted("crsm"), 12u + 12u);
}

TEST(PublishedStates, ConservativeMapsRefuseALamp) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view_with_lamp(64, 48, 64));
    EXPECT_THAT(error_of([&] { renderer->visibility(hybrid("crsm")); }), ::testing::HasSubstr("directional"));
    EXPECT_EQ(renderer->visibility(hybrid("beister")).size(), 64u * 48u);
}

} // namespace
} // namespace gnomon::testing
