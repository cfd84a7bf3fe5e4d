// Off-screen drawing: coverage, depth order, and both faces.
#include "runtime/error.h"
#include "runtime/gpu/device.h"
#include "tests/support/device.h"
#include "tests/support/temporary_folder.h"

#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::shared_device;

constexpr const char* vertex = R"(layout(std430, binding = 0) readonly buffer Corners { vec4 corners[]; };
layout(location = 0) flat out vec4 colour;
void main() {
    gl_Position = vec4(corners[gl_VertexIndex].xyz, 1.0);
    colour = vec4(float(gl_VertexIndex / 3 + 1), corners[gl_VertexIndex].w, 0.0, 1.0);
})";
constexpr const char* fragment = R"(layout(location = 0) flat in vec4 colour;
layout(location = 0) out vec4 result;
void main() { result = colour; })";

struct Drawn {
    std::vector<glm::vec4> colours;
    std::vector<float> depths;
};

constexpr std::uint32_t side = 8;

Drawn draw(const std::vector<glm::vec4>& corners, bool clamp_depth = false) {
    gpu::Device& device = shared_device();
    const auto compile = [](const char* text, glsl::Stage stage) {
        return glsl::compile({".", {}}, text, "m", stage);
    };
    gpu::Raster raster =
        device.raster(compile(vertex, glsl::Stage::vertex), compile(fragment, glsl::Stage::fragment),
                      {{gpu::Format::rgba32_float}, clamp_depth}, "raster_test");
    const gpu::Target colour = device.target(side, side, gpu::Format::rgba32_float);
    const gpu::Target depth = device.target(side, side, gpu::Format::depth32_float);
    const gpu::Buffer buffer = device.upload(corners);
    device.draw(raster, {&colour}, depth, {&buffer}, static_cast<std::uint32_t>(corners.size()));
    return {device.read<glm::vec4>(device.texels(colour)), device.read<float>(device.texels(depth))};
}

/// Half of the square below its falling diagonal, rows growing downwards.
std::vector<glm::vec4> lower_left(float z) { return {{-1, -1, z, 5}, {-1, 1, z, 5}, {1, 1, z, 5}}; }

TEST(raster, covers_the_texels_whose_centres_lie_inside) {
    const Drawn drawn = draw(lower_left(0.25f));
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            if (x == y) continue; // centres on the diagonal belong to one side or the other
            const std::size_t i = y * side + x;
            EXPECT_EQ(drawn.colours[i], x < y ? glm::vec4(1, 5, 0, 1) : glm::vec4(0)) << x << "," << y;
            EXPECT_EQ(drawn.depths[i], x < y ? 0.25f : 1.0f) << x << "," << y;
        }
}

TEST(raster, keeps_the_nearest_whatever_the_order_and_the_winding) {
    std::vector<glm::vec4> corners = lower_left(0.75f), near = lower_left(0.5f);
    std::swap(near[0], near[1]);
    corners.insert(corners.end(), near.begin(), near.end());
    const Drawn far_first = draw(corners);
    std::rotate(corners.begin(), corners.begin() + 3, corners.end());
    const Drawn near_first = draw(corners);
    const std::size_t inside = 6 * side + 1;
    EXPECT_EQ(far_first.depths[inside], 0.5f);
    EXPECT_EQ(near_first.depths[inside], 0.5f);
    EXPECT_EQ(far_first.colours[inside].x, 2.0f);
    EXPECT_EQ(near_first.colours[inside].x, 1.0f);
}

TEST(raster, clamps_depth_only_when_asked_to) {
    const std::size_t inside = 6 * side + 1;
    EXPECT_EQ(draw(lower_left(-0.5f)).colours[inside].x, 0.0f);
    const Drawn clamped = draw(lower_left(-0.5f), true);
    EXPECT_EQ(clamped.colours[inside].x, 1.0f);
    EXPECT_EQ(clamped.depths[inside], 0.0f);
}

TEST(raster, refuses_images_of_absurd_size) {
    for (const std::uint32_t wrong : {0u, 1000000u})
        EXPECT_THAT(testing::error_of([&] { shared_device().target(wrong, 4, gpu::Format::rgba32_float); }),
                    ::testing::HasSubstr("cannot be drawn"));
}

} // namespace
} // namespace gnomon
