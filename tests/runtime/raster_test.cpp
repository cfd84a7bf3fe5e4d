// Off-screen drawing: coverage, depth order, faces, and geometry shaders.
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

Drawn draw(const std::vector<glm::vec4>& corners, gpu::RasterState state = {},
           const char* geometry = nullptr) {
    gpu::Device& device = shared_device();
    const auto compile = [](const char* text, glsl::Stage stage) {
        return glsl::compile({".", {}}, text, "m", stage);
    };
    state.colours = {gpu::Format::rgba32_float};
    gpu::Raster raster =
        device.raster(compile(vertex, glsl::Stage::vertex), compile(fragment, glsl::Stage::fragment), state,
                      "raster_test", geometry ? compile(geometry, glsl::Stage::geometry) : glsl::Spirv{});
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
    const Drawn clamped = draw(lower_left(-0.5f), {.clamp_depth = true});
    EXPECT_EQ(clamped.colours[inside].x, 1.0f);
    EXPECT_EQ(clamped.depths[inside], 0.0f);
}

TEST(raster, draws_the_last_of_equally_deep_triangles) {
    std::vector<glm::vec4> corners = lower_left(0.5f);
    const std::vector<glm::vec4> again = corners;
    corners.insert(corners.end(), again.begin(), again.end());
    EXPECT_EQ(draw(corners).colours[6 * side + 1].x, 2.0f);
}

TEST(raster, leaves_out_the_faces_that_it_is_asked_to) {
    const std::size_t inside = 6 * side + 1;
    // Down the picture's left side, then to the right along its last row: counter-clockwise as one looks at
    // it.
    const std::vector<glm::vec4> front = lower_left(0.5f), back{front[0], front[2], front[1]};
    const auto drawn = [&](const std::vector<glm::vec4>& corners, gpu::Cull cull) {
        return draw(corners, {.cull = cull}).colours[inside].x == 1.0f;
    };
    EXPECT_TRUE(drawn(front, gpu::Cull::none));
    EXPECT_TRUE(drawn(back, gpu::Cull::none));
    EXPECT_FALSE(drawn(front, gpu::Cull::front));
    EXPECT_TRUE(drawn(back, gpu::Cull::front));
    EXPECT_TRUE(drawn(front, gpu::Cull::back));
    EXPECT_FALSE(drawn(back, gpu::Cull::back));
}

/// Leaves out the triangle itself and draws those beyond its three edges instead.
constexpr const char* neighbours_only = R"(layout(triangles_adjacency) in;
layout(triangle_strip, max_vertices = 9) out;
layout(location = 0) flat in vec4 colours[];
layout(location = 0) flat out vec4 colour;
void main() {
    for (int k = 0; k < 6; k += 2)
        for (int i = 0; i < 3; ++i) {
            gl_Position = gl_in[(k + i) % 6].gl_Position;
            colour = colours[1];
            EmitVertex();
            if (i == 2) EndPrimitive();
        }
})";

TEST(raster, gives_a_geometry_shader_a_triangle_and_its_neighbours) {
    if (!shared_device().has_geometry_shaders()) GTEST_SKIP() << "this device has no geometry shaders";
    // The square's middle, and three corners of the square that are folded out across its edges.
    const std::vector<glm::vec4> corners{{-0.5f, -0.5f, 0.5f, 7}, {-1, 0.5f, 0.5f, 7},
                                         {-0.5f, 0.5f, 0.5f, 7},  {0.5f, 1, 0.5f, 7},
                                         {0.5f, 0.5f, 0.5f, 7},   {1, -1, 0.5f, 7}};
    const Drawn drawn = draw(corners, {.topology = gpu::Topology::triangles_with_adjacency}, neighbours_only);
    // Texel centres lie at odd eighths. (-5/8, 3/8) is in the first neighbour, (3/8, 5/8) in the second,
    // (5/8, -5/8) in the third, (-3/8, 1/8) in the triangle itself.
    EXPECT_EQ(drawn.colours[5 * side + 1], glm::vec4(1, 7, 0, 1));
    EXPECT_EQ(drawn.colours[6 * side + 5], glm::vec4(1, 7, 0, 1));
    EXPECT_EQ(drawn.colours[1 * side + 6], glm::vec4(1, 7, 0, 1));
    EXPECT_EQ(drawn.colours[4 * side + 2], glm::vec4(0));
}

TEST(raster, refuses_adjacency_that_nothing_would_read) {
    EXPECT_THAT(testing::error_of(
                    [] { draw(lower_left(0.5f), {.topology = gpu::Topology::triangles_with_adjacency}); }),
                ::testing::HasSubstr("geometry shader"));
}

TEST(raster, refuses_images_of_absurd_size) {
    for (const std::uint32_t wrong : {0u, 1000000u})
        EXPECT_THAT(testing::error_of([&] { shared_device().target(wrong, 4, gpu::Format::rgba32_float); }),
                    ::testing::HasSubstr("cannot be drawn"));
}

} // namespace
} // namespace gnomon
