// What a frame does without changes nothing, and is truly not done.
#include "casegen/demo_scene.h"
#include "runtime/hybrid/facing.h"
#include "tests/pipeline/scenes.h"
#include "tests/pipeline/view.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gnomon::testing {
namespace {

struct Place {
    const char* name;
    Scene scene;
    View view;
};

/// The ground alone, from below: the light falls on the side that the camera does not see.
Place from_below() {
    Place place{"the ground from below", ground(6), {}};
    place.view = default_view(place.scene, 96, 64, 64);
    place.view.camera.position = {1, -5, 1.5f};
    place.view.camera.direction = {-0.2f, 1, -0.3f};
    return place;
}

/// No triangle is above any other, and no receiver is near an edge: all of it is certain.
Place empty_ground() {
    Place place{"the empty ground", ground(6), {}};
    place.view = default_view(place.scene, 96, 64, 64);
    return place;
}

Place into_the_sky() {
    Place place = empty_ground();
    place.name = "the sky";
    place.view.camera.direction = {0, 1, 0.001f};
    return place;
}

std::vector<Place> places() {
    std::vector<Place> all{from_below(), empty_ground(), into_the_sky()};
    Scene box = box_on_ground();
    const View view = default_view(box, 96, 64, 64);
    all.push_back({"a box", std::move(box), view});
    all.push_back({"the demo", demo_scene(), demo_view(160, 120, 128)});
    return all;
}

Technique technique(const std::string& name, bool prune) {
    return {.kind = Technique::Kind::hybrid, .name = name, .prune = prune};
}

bool has_step(const Rendering& rendering, const char* name) {
    return std::ranges::find(rendering.steps, name, &Step::name) != rendering.steps.end();
}

std::set<std::string> steps_left_out(const HybridFrame& frame) {
    std::set<std::string> steps;
    for (const LeftOut& left : frame.left_out) {
        steps.insert(left.step);
        EXPECT_NE(left.what, "");
        EXPECT_NE(left.why, "");
    }
    return steps;
}

/// Dispatches and draws of one frame from maps to fixed pixels.
std::uint64_t submissions_of_a_frame(Renderer& renderer, const Technique& of) {
    renderer.visibility(of); // compiles
    const std::uint64_t before = shared_device().submissions();
    renderer.visibility(of);
    return shared_device().submissions() - before;
}

TEST(LeavingOut, ChangesNoPixelAndNoState) {
    for (const Place& place : places())
        for (const HybridTechnique& hybrid : hybrid_techniques()) {
            SCOPED_TRACE(std::string(place.name) + ", " + hybrid.name);
            const auto renderer = make_renderer(place.scene, place.view);
            // What was there before is in the buffers: a step that is left out must not leave it there.
            renderer->render(no_shadows, 1);
            const Technique pruned = technique(hybrid.name, true), whole = technique(hybrid.name, false);
            const Rendering lean = renderer->render(pruned, 1);
            renderer->render(no_shadows, 1);
            const Rendering full = renderer->render(whole, 1);
            EXPECT_EQ(lean.visibility, full.visibility);
            EXPECT_TRUE(lean.image.pixels == full.image.pixels);
            EXPECT_EQ(renderer->states(pruned), renderer->states(whole));
            EXPECT_EQ(lean.hybrid->rays, full.hybrid->rays);
            EXPECT_EQ(lean.hybrid->facing, full.hybrid->facing);
            EXPECT_TRUE(full.hybrid->left_out.empty());
            EXPECT_TRUE(has_step(full, "trace") && has_step(full, "fix"));
        }
}

TEST(LeavingOut, DoesNothingWhereNoPixelFacesTheLight) {
    for (const Place& place : {from_below(), into_the_sky()})
        for (const HybridTechnique& hybrid : hybrid_techniques()) {
            SCOPED_TRACE(std::string(place.name) + ", " + hybrid.name);
            const auto renderer = make_renderer(place.scene, place.view);
            const Rendering lean = renderer->render(technique(hybrid.name, true), 1);
            EXPECT_EQ(lean.hybrid->facing, 0u);
            EXPECT_FALSE(has_step(lean, "build BVH") || has_step(lean, "trace") || has_step(lean, "fix"));
            EXPECT_TRUE(std::ranges::all_of(lean.visibility, [](float v) { return v == 0.0f; }));
            const std::set<std::string> left = steps_left_out(*lean.hybrid);
            EXPECT_TRUE(left.contains("fill") && left.contains("trace") && left.contains("fix"));
            if (!left.contains("create maps")) continue; // a technique without maps
            EXPECT_TRUE(left.contains("detect"));
            EXPECT_EQ(lean.hybrid->maps.triangles_emitted, 0u);
            EXPECT_EQ(submissions_of_a_frame(*renderer, technique(hybrid.name, true)), 1u); // the question
            EXPECT_GT(submissions_of_a_frame(*renderer, technique(hybrid.name, false)), 3u);
        }
}

TEST(LeavingOut, BuildsNoBvhWhereNoPixelIsUncertain) {
    const Place place = empty_ground();
    const auto renderer = make_renderer(place.scene, place.view);
    const Technique lists = technique("lists", true);
    const Rendering lean = renderer->render(lists, 1);
    ASSERT_GT(lean.hybrid->facing, 500u);
    ASSERT_EQ(lean.hybrid->rays, 0u);
    EXPECT_FALSE(has_step(lean, "build BVH") || has_step(lean, "trace") || has_step(lean, "fix"));
    EXPECT_TRUE(has_step(lean, "create maps") && has_step(lean, "detect"));
    EXPECT_EQ(steps_left_out(*lean.hybrid), (std::set<std::string>{"fill", "trace", "fix"}));
    const std::uint64_t least = submissions_of_a_frame(*renderer, lists);
    const Technique whole = technique("lists", false);
    EXPECT_EQ(submissions_of_a_frame(*renderer, whole), least - 1 + 2); // no question; fill and fix
    EXPECT_TRUE(has_step(renderer->render(whole, 1), "trace"));
}

TEST(LeavingOut, LeavesNothingOutWhereEveryStepIsNeeded) {
    const Place place{"the demo", demo_scene(), demo_view(160, 120, 128)};
    const auto renderer = make_renderer(place.scene, place.view);
    const Rendering rendering = renderer->render(technique("sheet", true), 1);
    EXPECT_GT(rendering.hybrid->rays, 0u);
    EXPECT_TRUE(rendering.hybrid->left_out.empty());
    EXPECT_TRUE(has_step(rendering, "build BVH") && has_step(rendering, "trace"));
}

/// One pixel that faces the light, wherever it is, is found; none is not.
TEST(FacingTest, FindsTheOnlyPixel) {
    gpu::Device& device = shared_device();
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(97, 61), glm::uvec2(512, 300)}) {
        const Scene none;
        Resources resources{device, kernel_sources(kernels_folder()), none, {}, 0};
        resources.frame.size = {size, 1, 0};
        resources.frame_buffer = device.upload(std::span<const shared::Frame>(&resources.frame, 1));
        std::vector<shared::Receiver> receivers(std::size_t{size.x} * size.y);
        for (std::size_t i = 0; i < receivers.size(); ++i) receivers[i].map.w = i % 3 == 0 ? 0.0f : -1.0f;
        resources.receivers = device.upload(receivers);
        FacingTest test(resources);
        EXPECT_FALSE(test.any());
        for (const std::size_t at : {std::size_t{0}, receivers.size() / 2, receivers.size() - 1}) {
            std::vector<shared::Receiver> one = receivers;
            one[at].map.w = 1;
            device.write(resources.receivers, std::as_bytes(std::span(one)));
            EXPECT_TRUE(test.any()) << at << " of " << receivers.size();
        }
        device.write(resources.receivers, std::as_bytes(std::span(receivers)));
        EXPECT_FALSE(test.any()) << "remembers";
    }
}

} // namespace
} // namespace gnomon::testing
