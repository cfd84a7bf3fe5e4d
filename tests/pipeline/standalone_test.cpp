// What the pipeline computes is what the kernels compute alone, bit for bit.
#include "casegen/capture.h"
#include "casegen/catalogue.h"
#include "casegen/demo_scene.h"
#include "casegen/standalone.h"
#include "casegen/technique.h"
#include "tests/pipeline/view.h"
#include "tests/support/case_chain.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace gnomon::testing {
namespace {

constexpr int window = 2 * Capture::radius + 1;

/// What one pixel's kernel saw, as a mask. No walk leaves the window, so it must not matter what lies beyond.
Mask mask_of(const Capture& capture, Outside outside) {
    Mask mask(window, window, true, outside);
    mask.texels = capture.lit;
    return mask;
}

struct Pixel {
    std::uint32_t index;
    glm::vec2 p;
    Mask mask;
};

std::vector<Pixel> pixels_of(Renderer& renderer) {
    constexpr glm::ivec2 centre(Capture::radius);
    const std::vector<std::uint32_t> asked = asked_pixels(renderer);
    const std::vector<Capture> captures = renderer.capture(asked);
    std::vector<Pixel> pixels;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const glm::vec2 map(renderer.receivers()[asked[i]].map);
        EXPECT_EQ(captures[i].texel, glm::ivec2(glm::floor(map))) << "pixel " << asked[i];
        EXPECT_EQ(captures[i].p, map - glm::floor(map)) << "pixel " << asked[i];
        Mask mask = mask_of(captures[i], std::array{Outside::clamp, Outside::lit, Outside::shadow}[i % 3]);
        const bool edge = reference::discontinuity(mask, centre) != glm::uvec2(0);
        if (edge || i % 7 == 0) pixels.push_back({asked[i], captures[i].p, std::move(mask)});
    }
    return pixels;
}

std::vector<std::uint32_t> alone(const std::string& kernel, const std::vector<Pixel>& pixels, bool with_p) {
    Records records(find_case(kernel));
    for (const Pixel& pixel : pixels) {
        const std::array<std::uint32_t, 4> words{Capture::radius, Capture::radius,
                                                 std::bit_cast<std::uint32_t>(pixel.p.x),
                                                 std::bit_cast<std::uint32_t>(pixel.p.y)};
        records.add(std::span(words).first(with_p ? 4 : 2), &pixel.mask);
    }
    return run_kernel(kernel, records);
}

void expect_same(const std::vector<Pixel>& pixels, const std::vector<std::uint32_t>& standalone,
                 const std::vector<float>& pipeline, const char* what) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (standalone[i] != std::bit_cast<std::uint32_t>(pipeline[pixels[i].index]) && differing++ == 0)
            ADD_FAILURE() << what << " at pixel " << pixels[i].index << ", p " << pixels[i].p.x << ' '
                          << pixels[i].p.y << ": alone " << std::bit_cast<float>(standalone[i])
                          << ", in the pipeline " << pipeline[pixels[i].index] << ", over\n"
                          << format_mask(pixels[i].mask, '\n');
    EXPECT_EQ(differing, 0u) << what << ", of " << pixels.size();
}

/// By technique, how many pixels were of each case; 0 is none.
using Met = std::map<std::string, std::map<unsigned, std::size_t>>;

/// Every technique's kernels, in the pipeline and alone; and the numbers against the cases' own conditions.
void compare(const View& view, Met& met) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, view);
    const std::vector<Pixel> pixels = pixels_of(*renderer);
    EXPECT_GT(pixels.size(), 2000u);
    for (const std::string& name : visibility_techniques()) {
        const Family& family = technique_family(name);
        expect_same(pixels, alone(find_kernel(family, "visibility")->name, pixels, true),
                    visibility(*renderer, technique_of(family)), name.c_str());
        const Case* number_kernel = find_kernel(family, "number");
        if (!number_kernel) continue;
        const CaseChain chain(family.name);
        const std::vector<std::uint32_t> numbers = alone(number_kernel->name, pixels, false);
        std::size_t differing = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Case* c = chain.case_of(reference::edge(pixels[i].mask, glm::ivec2(Capture::radius)));
            const unsigned wanted = c ? c->number : 0;
            ++met[name][wanted];
            if (numbers[i] != wanted && differing++ == 0)
                ADD_FAILURE() << name << ": case " << numbers[i] << ", by the reference " << wanted
                              << ", over\n"
                              << format_mask(pixels[i].mask, '\n');
        }
        EXPECT_EQ(differing, 0u) << name;
    }
}

/// Every case must have been compared, and nothing (0) too.
void expect_all_cases(const Met& met) {
    for (const auto& [name, counts] : met) {
        fmt::print("{}: pixels by case: {}\n", name, counts);
        EXPECT_TRUE(counts.contains(0)) << name;
        for (const Case* c : numbered_cases(technique_family(name)))
            EXPECT_TRUE(counts.contains(c->number)) << "no pixel is of " << c->name;
    }
    EXPECT_EQ(met.size(), numbered_techniques().size());
}

/// The window of a pixel, worked out here from the shadow map, the pixel's plane and the bias; beyond the map
/// the nearest texel answers.
void expect_shadow_tests(const View& view) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, view);
    const shared::Frame frame = make_frame(view.camera, view.light, view.settings, scene.bounds());
    const std::vector<float> depths = renderer->shadow_map();
    const double near = frame.range.x, far = frame.range.y, bias = frame.range.z;
    const int side = view.settings.shadow_map;
    std::vector<std::uint32_t> pixels;
    for (const std::uint32_t pixel : asked_pixels(*renderer))
        if (pixel % 41 == 0) pixels.push_back(pixel);
    std::size_t beyond = 0, compared = 0, differing = 0, shadowed = 0;
    for (const auto captures = renderer->capture(pixels); const Capture& capture : captures) {
        const shared::Receiver& receiver =
            renderer->receivers()[pixels[static_cast<std::size_t>(&capture - captures.data())]];
        for (int n = 0; n < window * window; ++n) {
            const glm::ivec2 there = capture.texel + glm::ivec2(n % window, n / window) - Capture::radius;
            const glm::ivec2 texel = glm::clamp(there, glm::ivec2(0), glm::ivec2(side - 1));
            const glm::dvec2 offset = glm::dvec2(texel) + 0.5 - glm::dvec2(receiver.map.x, receiver.map.y);
            const double slope = glm::dot(glm::dvec2(receiver.slope.x, receiver.slope.y), offset);
            double depth = static_cast<double>(receiver.map.z) + (view.settings.receiver_plane ? slope : 0);
            if (view.light.position) depth = depth > 0 ? (1 / depth - near) / (far - near) : 1;
            depth = std::min(depth, 1.0);
            const double margin =
                static_cast<double>(depths[static_cast<std::size_t>(texel.y * side + texel.x)]) - depth +
                bias;
            if (std::abs(margin) < 1e-5) continue;
            ++compared;
            beyond += there != texel ? 1 : 0;
            shadowed += margin < 0 ? 1 : 0;
            differing += (capture.lit[static_cast<std::size_t>(n)] != 0) != (margin > 0) ? 1 : 0;
        }
    }
    EXPECT_EQ(differing, 0u) << "of " << compared;
    EXPECT_GT(compared, 300000u);
    EXPECT_GT(beyond, 3000u);
    EXPECT_GT(shadowed, 10000u);
}

TEST(Capture, HoldsTheShadowTestOfEveryTexelAround) {
    for (View view : {demo_view(160, 120, 64), demo_view_with_lamp(160, 120, 64)})
        for (const bool plane : {true, false}) {
            view.settings.receiver_plane = plane;
            view.settings.bias = plane ? 0 : 0.03f;
            expect_shadow_tests(view);
        }
}

TEST(Capture, HoldsAMapWithoutIsolatedTexelsWhereThatIsAskedFor) {
    const View view = demo_view(160, 120, 64);
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, view);
    Renderer flipping(shared_device(), kernel_sources(kernels_folder(), {.flip_isolated = true}), scene,
                      view.camera, view.light, view.settings);
    const std::vector<std::uint32_t> pixels = asked_pixels(*renderer);
    const std::vector<Capture> plain = renderer->capture(pixels), flipped = flipping.capture(pixels);
    std::size_t moved = 0, differing = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Mask before = mask_of(plain[i], Outside::clamp), after = mask_of(flipped[i], Outside::clamp);
        const Mask wanted = without_isolated(before);
        for (int y = 1; y < window - 1; ++y) // what the border's texels differ from is not in the window
            for (int x = 1; x < window - 1; ++x) {
                moved += wanted.lit(x, y) != before.lit(x, y) ? 1 : 0;
                differing += wanted.lit(x, y) != after.lit(x, y) ? 1 : 0;
            }
    }
    EXPECT_EQ(differing, 0u);
    EXPECT_GT(moved, 1000u);
}

TEST(Capture, OfNoPixelIsEmpty) {
    const Scene scene = demo_scene();
    EXPECT_TRUE(make_renderer(scene, demo_view(16, 12, 16))->capture({}).empty());
}

TEST(PipelineEqualsStandalone, WithTheSunAndWithALamp) {
    Met met;
    compare(demo_view(320, 240, 256), met);
    compare(demo_view_with_lamp(320, 240, 256), met);
    compare(demo_view(320, 240, 48), met); // a coarse map, whose border is in sight
    expect_all_cases(met);
}

TEST(PipelineEqualsStandalone, WithTheReceiversDepthAlone) {
    for (View view : {demo_view(320, 240, 256), demo_view_with_lamp(320, 240, 256)}) {
        view.settings.receiver_plane = false;
        Met met;
        compare(view, met);
    }
}

} // namespace
} // namespace gnomon::testing
