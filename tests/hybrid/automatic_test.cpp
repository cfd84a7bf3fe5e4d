// auto renders the exact image with a technique that it names, and frames of several techniques are told
// apart.
#include "casegen/demo_scene.h"
#include "tests/pipeline/view.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon::testing {
namespace {

const Technique automatic{.kind = Technique::Kind::automatic, .name = "auto"};

TEST(Automatic, GivesTheRayTracersImageWithATechniqueThatIsExact) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view(160, 120, 128));
    const Rendering truth = renderer->render(raytraced, 1), found = renderer->render(automatic, 1);
    EXPECT_EQ(found.visibility, truth.visibility);
    ASSERT_TRUE(found.choice && found.hybrid);
    const HybridTechnique* chosen = find_hybrid(found.choice->name());
    ASSERT_NE(chosen, nullptr);
    EXPECT_TRUE(chosen->sound);
    std::size_t exact = 0;
    for (const HybridTechnique& technique : hybrid_techniques()) exact += technique.sound ? 1 : 0;
    EXPECT_EQ(found.choice->candidates.size(), exact);
    EXPECT_GT(found.choice->milliseconds, 0);
    // Kept: the same times again.
    EXPECT_EQ(renderer->choice().candidates[0].milliseconds, found.choice->candidates[0].milliseconds);
    EXPECT_FALSE(truth.choice);
}

TEST(Automatic, IsCalibratedAnewForAnotherView) {
    const Scene scene = demo_scene();
    const View view = demo_view(80, 60, 64);
    const auto renderer = make_renderer(scene, view);
    const std::vector<double> before = renderer->choice().candidates[0].milliseconds;
    Camera camera = view.camera;
    camera.position.y += 1;
    renderer->look(camera, view.light);
    EXPECT_NE(renderer->choice().candidates[0].milliseconds, before);
}

/// Techniques that need a directional light refuse; a ray for every pixel does not.
TEST(Automatic, TakesWhatALampAllows) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view_with_lamp(80, 60, 64));
    const Rendering truth = renderer->render(raytraced, 1), found = renderer->render(automatic, 1);
    EXPECT_EQ(found.visibility, truth.visibility);
    EXPECT_TRUE(std::ranges::any_of(found.choice->candidates,
                                    [](const Candidate& candidate) { return !candidate.refused.empty(); }));
}

TEST(TimeHybrids, KeepsTechniquesApart) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view(160, 120, 128));
    const std::vector<Technique> techniques{
        {.kind = Technique::Kind::hybrid, .name = hybrid_techniques().front().name},
        {.kind = Technique::Kind::hybrid, .name = "lists"},
        automatic};
    const std::vector<TechniqueTimes> times = renderer->time_techniques(techniques, 2);
    ASSERT_EQ(times.size(), 3u);
    EXPECT_EQ(times[0].frame.rays, times[0].frame.facing);
    EXPECT_LT(times[1].frame.rays, times[0].frame.rays / 2);
    EXPECT_EQ(times[0].frame.maps.triangles_emitted, 0u);
    EXPECT_GT(times[1].frame.maps.triangles_emitted, 0u);
    for (const TechniqueTimes& each : times) {
        EXPECT_EQ(each.visibility, times[0].visibility);
        EXPECT_LE(each.least, each.milliseconds);
        EXPECT_LE(each.milliseconds, each.most);
        double sum = 0;
        for (const Step& step : each.steps) {
            EXPECT_NE(step.name, "build BVH") << "of the first round, which is discarded";
            sum += step.milliseconds;
        }
        EXPECT_LE(sum, 1.5 * each.most);
    }
}

} // namespace
} // namespace gnomon::testing
