// What the pipeline computes is what the kernels compute alone, bit for bit.
#include "casegen/catalogue.h"
#include "casegen/demo_scene.h"
#include "casegen/standalone.h"
#include "tests/pipeline/view.h"
#include "tests/support/device.h"
#include "tests/support/smsr_chain.h"

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
    unsigned number; ///< by the host's reference
};

std::vector<Pixel> pixels_of(Renderer& renderer, const View& view) {
    constexpr glm::ivec2 centre(Capture::radius);
    const std::vector<std::uint32_t> asked = asked_pixels(renderer, view);
    const std::vector<Capture> captures = renderer.capture(asked);
    std::vector<Pixel> pixels;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const glm::vec2 map(renderer.receivers()[asked[i]].map);
        EXPECT_EQ(captures[i].texel, glm::ivec2(glm::floor(map))) << "pixel " << asked[i];
        EXPECT_EQ(captures[i].p, map - glm::floor(map)) << "pixel " << asked[i];
        Mask mask = mask_of(captures[i], std::array{Outside::clamp, Outside::lit, Outside::shadow}[i % 3]);
        const Case* c = mask.lit(centre.x, centre.y) ? smsr_case_of(reference::edge(mask, centre)) : nullptr;
        const unsigned number = c ? c->number : 0;
        if (number != 0 || i % 7 == 0) pixels.push_back({asked[i], captures[i].p, std::move(mask), number});
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

/// Pixels by the number of their case.
std::map<unsigned, std::size_t> compare(const View& view) {
    const Scene scene = demo_scene();
    const auto renderer = make_renderer(scene, view);
    const std::vector<Pixel> pixels = pixels_of(*renderer, view);
    EXPECT_GT(pixels.size(), 2000u);

    expect_same(pixels, alone("nsm/visibility", pixels, true), visibility(*renderer, nsm), "nsm");
    expect_same(pixels, alone("smsr/visibility", pixels, true), visibility(*renderer, smsr), "smsr");
    const std::vector<std::uint32_t> numbers = alone("smsr/number", pixels, false);
    std::map<unsigned, std::size_t> counts;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        ++counts[pixels[i].number];
        if (numbers[i] != pixels[i].number && differing++ == 0)
            ADD_FAILURE() << "case " << numbers[i] << ", by the reference " << pixels[i].number << ", over\n"
                          << format_mask(pixels[i].mask, '\n');
    }
    EXPECT_EQ(differing, 0u);
    fmt::print("pixels by case: {}\n", counts);
    return counts;
}

/// Every case of the twelve must have been compared, and nothing (0) too.
void expect_all_cases(const std::map<unsigned, std::size_t>& counts) {
    for (unsigned number = 0; number <= 12; ++number)
        EXPECT_TRUE(counts.contains(number)) << "no pixel is of case " << number;
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
    for (const std::uint32_t pixel : asked_pixels(*renderer, view))
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

TEST(Capture, OfNoPixelIsEmpty) {
    const Scene scene = demo_scene();
    EXPECT_TRUE(make_renderer(scene, demo_view(16, 12, 16))->capture({}).empty());
}

TEST(PipelineEqualsStandalone, WithADirectionalLight) { expect_all_cases(compare(demo_view(320, 240, 256))); }

TEST(PipelineEqualsStandalone, WithALamp) { expect_all_cases(compare(demo_view_with_lamp(320, 240, 256))); }

TEST(PipelineEqualsStandalone, WithTheReceiversDepthAlone) {
    for (View view : {demo_view(320, 240, 256), demo_view_with_lamp(320, 240, 256)}) {
        view.settings.receiver_plane = false;
        compare(view);
    }
}

TEST(PipelineEqualsStandalone, OverACoarseMapWhoseBorderIsInSight) { compare(demo_view(320, 240, 48)); }

} // namespace
} // namespace gnomon::testing
