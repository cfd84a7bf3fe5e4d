// Leaving out the cases that a view does not need changes no pixel, whatever the view turns into.
#include "casegen/capture.h"
#include "casegen/census.h"
#include "casegen/demo_scene.h"
#include "casegen/readings.h"
#include "casegen/technique.h"
#include "tests/pipeline/scenes.h"
#include "tests/pipeline/view.h"
#include "tests/support/device.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

namespace gnomon::testing {
namespace {

std::size_t differing(const Rendering& a, const Rendering& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.visibility.size(); ++i)
        if (std::bit_cast<std::uint32_t>(a.visibility[i]) != std::bit_cast<std::uint32_t>(b.visibility[i]) ||
            !(a.image.pixels[i] == b.image.pixels[i]))
            ++count;
    return count;
}

class Assemblies : public ::testing::TestWithParam<std::string> {
protected:
    const Family& family = technique_family(GetParam());
    const Technique full = technique_of(family);

    Assembly assembly_of(Renderer& renderer, Variant variant = Variant::switch_by_number) const {
        return {variant, cases_by_frequency(family, renderer.census(full))};
    }

    /// A view's own cases are enough for it.
    void expect_enough(const Scene& scene, const View& view, const std::string& what) const {
        const auto renderer = make_renderer(scene, view);
        const Rendering expected = renderer->render(full, 1);
        EXPECT_EQ(expected.left_out, 0u);
        for (const Variant variant : {Variant::switch_by_number, Variant::branch_tree}) {
            if (variant == Variant::branch_tree && view.settings.shadow_map != 512) continue; // one is enough
            const Rendering got = renderer->render(technique_of(family, assembly_of(*renderer, variant)), 1);
            EXPECT_EQ(got.left_out, 0u) << what << ", " << to_string(variant);
            EXPECT_EQ(differing(got, expected), 0u) << what << ", " << to_string(variant);
        }
    }
};

std::vector<std::pair<std::string, Scene>> scenes() {
    Scene steps = ground(5);
    for (int i = 0; i < 5; ++i) {
        const auto f = static_cast<float>(i);
        add_box(steps, {-3 + f, 0, -2}, {-2.5f + f, 0.4f + 0.3f * f, 2 - 0.7f * f});
    }
    return {{"demo", demo_scene()}, {"box", box_on_ground()}, {"steps", steps}, {"nothing casts", ground(4)}};
}

TEST_P(Assemblies, OfAViewsOwnCasesGiveItsImage) {
    for (const auto& [name, scene] : scenes())
        for (const bool lamp : {false, true})
            for (const int side : {256, 512, 1024, 2048}) {
                View view = default_view(scene, 200, 150, side);
                if (name == "demo") view = demo_view(200, 150, side);
                if (lamp)
                    view.light = {
                        .direction = {0.3f, -1, 0.2f}, .position = glm::vec3(-1.5f, 6, -1), .fov = 110};
                expect_enough(scene, view, fmt::format("{}, {}, {}", name, lamp ? "lamp" : "sun", side));
            }
}

TEST_P(Assemblies, OfAnotherLightsCasesFallBack) {
    const Scene scene = box_on_ground();
    View view = default_view(scene, 240, 180, 256);
    view.light.direction = {0, -1, 0.6f}; // the box's shadow is straight: few cases
    const Assembly first = assembly_of(*make_renderer(scene, view));
    EXPECT_FALSE(left_out_cases(family, first).empty());
    int fallen_back = 0, kept = 0;
    for (unsigned i = 0; i < 8; ++i) {
        view.light.direction = glm::vec3(0.1f * static_cast<float>(i), -1, 0.6f);
        const auto renderer = make_renderer(scene, view);
        const Rendering got = renderer->render(technique_of(family, first), 1);
        EXPECT_EQ(differing(got, renderer->render(full, 1)), 0u) << "light " << i;
        const bool has_step = std::ranges::find(got.steps, "all cases", &Step::name) != got.steps.end();
        EXPECT_EQ(has_step, got.left_out > 0);
        ++(got.left_out > 0 ? fallen_back : kept);
    }
    EXPECT_GT(fallen_back, 0) << "no light asked for a case that the first one did not have";
    EXPECT_GT(kept, 0);
}

TEST_P(Assemblies, ThatHoldNothingFallBackEntirely) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view(240, 180, 512));
    const Counts counts = renderer->census(full);
    std::uint64_t of_cases = 0;
    for (const Case* c : numbered_cases(family)) of_cases += counts[c->number];
    ASSERT_GT(of_cases, 500u);
    const Rendering expected = renderer->render(full, 1);
    for (const Variant variant : all_variants()) {
        Technique nothing = technique_of(family, {variant, {0}});
        const Rendering got = renderer->render(nothing, 1);
        EXPECT_EQ(got.left_out, of_cases) << to_string(variant);
        EXPECT_EQ(differing(got, expected), 0u) << to_string(variant);
        // The same assembly where nobody looks at the count: the image is wrong, so the test above sees.
        nothing.falls_back = false;
        EXPECT_GT(differing(renderer->render(nothing, 1), expected), 100u) << to_string(variant);
    }
    EXPECT_EQ(differing(renderer->render(full, 1), expected), 0u) << "a count was left behind";
}

TEST_P(Assemblies, LeftOutOneByOneAreMissedByTheirPixels) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view(240, 180, 256));
    const Counts counts = renderer->census(full);
    const Rendering expected = renderer->render(full, 1);
    for (const Case* without : numbered_cases(family)) {
        Assembly assembly;
        for (const Case* c : numbered_cases(family))
            if (c != without) assembly.cases.push_back(c->number);
        const Rendering got = renderer->render(technique_of(family, assembly), 1);
        EXPECT_EQ(got.left_out, counts[without->number]) << without->name;
        EXPECT_EQ(differing(got, expected), 0u) << without->name;
    }
}

/// The frame that is found again is of the same reading.
TEST(AssembliesOfAReading, FallBackToTheSameReading) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, demo_view(160, 120, 64));
    const Family& family = technique_family("rsmss");
    Technique full = technique_of(family), nothing = technique_of(family, {Variant::switch_by_number, {0}});
    const Rendering usual = renderer->render(full, 1);
    for (Technique* technique : {&full, &nothing})
        technique->generated.merge(
            reading_sources(parse_readings({"bar=ramp", "slot-end=printed", "long-runs=whole"})));
    const Rendering wanted = renderer->render(full, 1), got = renderer->render(nothing, 1);
    EXPECT_GT(got.left_out, 0u);
    EXPECT_EQ(got.visibility, wanted.visibility);
    EXPECT_NE(got.visibility, usual.visibility);
}

INSTANTIATE_TEST_SUITE_P(Of, Assemblies, ::testing::ValuesIn(numbered_techniques()));

/// Every pixel that is asked, by the number that its capture has alone.
TEST_P(Assemblies, CensusCountsWhatEachPixelIsAlone) {
    const Scene scene = demo_scene();
    for (const View& view : {demo_view(200, 150, 256), demo_view_with_lamp(200, 150, 48)}) {
        const auto renderer = make_renderer(scene, view);
        const std::vector<Capture> captures = renderer->capture(asked_pixels(*renderer));
        constexpr int side = 2 * Capture::radius + 1;
        std::vector<Mask> masks(captures.size(), Mask(side, side));
        const Case& number = *find_kernel(family, "number");
        Records records(number);
        for (std::size_t i = 0; i < captures.size(); ++i) {
            masks[i].texels = captures[i].lit;
            records.add(std::array<std::uint32_t, 2>{Capture::radius, Capture::radius}, &masks[i]);
        }
        Counts expected(Renderer::census_size);
        for (const std::uint32_t n : run_kernel(number.name, records)) ++expected[n];
        EXPECT_EQ(renderer->census(full), expected);
        EXPECT_GT(expected[0], 1000u);
    }
}

} // namespace
} // namespace gnomon::testing
