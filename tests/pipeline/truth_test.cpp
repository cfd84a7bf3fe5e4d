// Renderings of the demo scene against the truth.
#include "casegen/demo_scene.h"
#include "tests/pipeline/view.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace gnomon::testing {
namespace {

class OnTheDemoScene : public ::testing::TestWithParam<bool> {
protected:
    static View view(int shadow_map) {
        return GetParam() ? demo_view_with_lamp(320, 240, shadow_map) : demo_view(320, 240, shadow_map);
    }
    Scene scene_ = demo_scene();
};

TEST_P(OnTheDemoScene, TheTruthIsTheSameForAnyNumberOfThreads) {
    const auto renderer = make_renderer(scene_, view(64));
    const std::vector<float> first = visibility(*renderer, raytraced);
    EXPECT_EQ(visibility(*renderer, raytraced), first);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(visibility(*make_renderer(scene_, view(64)), raytraced), first);
}

TEST_P(OnTheDemoScene, KernelsAnswerTheSameFromRunToRun) {
    for (const Technique& technique : {nsm, smsr}) {
        const auto renderer = make_renderer(scene_, view(256));
        const Rendering first = renderer->render(technique, 1);
        EXPECT_EQ(renderer->render(technique, 3).visibility, first.visibility);
        const Rendering again = make_renderer(scene_, view(256))->render(technique, 1);
        EXPECT_EQ(again.visibility, first.visibility);
        EXPECT_EQ(again.image.pixels, first.image.pixels);
    }
}

TEST_P(OnTheDemoScene, CountsAddUp) {
    const auto renderer = make_renderer(scene_, view(256));
    const std::vector<float> truth = visibility(*renderer, raytraced);
    for (const Technique& technique : {no_shadows, nsm, smsr, raytraced}) {
        SCOPED_TRACE(technique.name);
        const std::vector<float> v = visibility(*renderer, technique);
        const PixelCounts c = count_pixels(renderer->surfaces(), v, truth);
        EXPECT_EQ(c.all, 320u * 240u);
        EXPECT_LT(c.covered, c.all);
        EXPECT_EQ(c.covered, c.facing + c.facing_away);
        EXPECT_EQ(c.facing, c.truly_lit + c.truly_shadowed);
        EXPECT_GT(c.facing_away, 0u);
        EXPECT_GT(c.truly_lit, 0u);
        EXPECT_GT(c.truly_shadowed, 0u);
        EXPECT_LE(c.wrong_lit, c.truly_shadowed);
        EXPECT_LE(c.wrong_shadowed, c.truly_lit);
        if (technique.kind == Technique::Kind::raytraced) EXPECT_EQ(c.wrong_share(), 0);
        if (technique.kind == Technique::Kind::none) {
            EXPECT_EQ(c.wrong_lit, c.truly_shadowed);
            EXPECT_EQ(c.wrong_shadowed, 0u);
        }
        for (std::size_t i = 0; i < v.size(); ++i) {
            ASSERT_TRUE(v[i] == 0 || v[i] == 1) << i;
            if (renderer->surfaces().facing[i] == 0) ASSERT_EQ(v[i], 0) << i;
        }
    }
}

TEST_P(OnTheDemoScene, SmsrOnlyAddsShadow) {
    for (const bool plane : {true, false}) {
        View v = view(256);
        v.settings.receiver_plane = plane;
        const auto renderer = make_renderer(scene_, v);
        const std::vector<float> plain = visibility(*renderer, nsm), straight = visibility(*renderer, smsr);
        EXPECT_EQ(lit_only_in_first(renderer->surfaces(), straight, plain), 0u);
        EXPECT_GT(lit_only_in_first(renderer->surfaces(), plain, straight), 500u);
        const std::vector<float> truth = visibility(*renderer, raytraced);
        const PixelCounts by_nsm = count_pixels(renderer->surfaces(), plain, truth);
        const PixelCounts by_smsr = count_pixels(renderer->surfaces(), straight, truth);
        EXPECT_LT(by_smsr.wrong_lit * 2, by_nsm.wrong_lit);
    }
}

/// Wrong pixels lie along borders of shadows, in a band as wide as a texel.
TEST_P(OnTheDemoScene, ErrorsShrinkWithTheTexel) {
    std::vector<double> shares;
    for (const int side : {512, 2048}) {
        const auto renderer = make_renderer(scene_, view(side));
        const std::vector<float> truth = visibility(*renderer, raytraced);
        shares.push_back(count_pixels(renderer->surfaces(), visibility(*renderer, nsm), truth).wrong_share());
        fmt::print("shadow map {}: {:.3f} % of pixels wrong\n", side, 100 * shares.back());
    }
    EXPECT_GT(shares[0], 2.5 * shares[1]);
    EXPECT_LT(shares[1], 0.03);
}

INSTANTIATE_TEST_SUITE_P(Light, OnTheDemoScene, ::testing::Values(false, true),
                         [](const auto& light) { return light.param ? "lamp" : "sun"; });

/// The median drops each step's first time, and every technique names its own steps.
TEST(Steps, AreNamedInTheirOrder) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view(64, 48, 64));
    const auto names = [&](const Technique& technique) {
        std::vector<std::string> result;
        for (const Step& step : renderer->render(technique, 2).steps) {
            result.push_back(step.name);
            EXPECT_GE(step.milliseconds, 0) << step.name;
            EXPECT_LT(step.milliseconds, 1e4) << step.name;
        }
        return result;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names(nsm), (Names{"g-buffer", "receivers", "shadow map", "visibility", "shade"}));
    EXPECT_EQ(names(raytraced), (Names{"g-buffer", "receivers", "build BVH", "trace", "shade"}));
    EXPECT_EQ(names(raytraced), (Names{"g-buffer", "receivers", "trace", "shade"}));
    EXPECT_EQ(names(no_shadows), (Names{"g-buffer", "receivers", "shade"}));
}

} // namespace
} // namespace gnomon::testing
