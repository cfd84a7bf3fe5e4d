// Bindings, push constants and workgroup sizes, read from SPIR-V.
#include "runtime/glsl/reflection.h"

#include "runtime/error.h"
#include "tests/support/environment.h"

#include <gtest/gtest.h>

namespace gnomon {
namespace {

glsl::Reflection reflect(const std::string& text) {
    return glsl::reflect(glsl::compile({testing::kernels_folder(), {}}, text, "m", glsl::Stage::compute),
                         "m");
}

TEST(reflection, finds_buffers_in_order_constants_and_workgroup) {
    const glsl::Reflection r = reflect(R"(layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
layout(std430, binding = 7) buffer B { uint b[]; };
layout(std430, binding = 2) readonly buffer A { uint a[]; };
layout(push_constant) uniform Constants { uvec4 c; float d; };
void main() { b[0] = a[0] + c.x + uint(d); })");
    EXPECT_EQ(r.storage_buffers, (std::vector<std::uint32_t>{2, 7}));
    EXPECT_EQ(r.push_constant_bytes, 20u);
    EXPECT_EQ(r.workgroup_size, (std::array<std::uint32_t, 3>{8, 4, 2}));
}

TEST(reflection, two_views_of_one_buffer_are_one_binding) {
    const glsl::Reflection r = reflect(R"(layout(local_size_x = 1) in;
layout(std430, binding = 1) buffer A { uint a[]; };
layout(std430, binding = 1) buffer B { float b[]; };
void main() { a[0] = 1u; b[1] = 2.0; })");
    EXPECT_EQ(r.storage_buffers, std::vector<std::uint32_t>{1});
}

TEST(reflection, refuses_what_the_runtime_does_not_offer) {
    for (const char* resource :
         {"layout(binding = 0) uniform sampler2D map; void main() { texelFetch(map, ivec2(0), 0); }",
          "layout(binding = 0, r32f) uniform image2D map; void main() { imageStore(map, ivec2(0), vec4(0)); "
          "}",
          "layout(std140, binding = 0) uniform Block { vec4 v; }; layout(std430, binding = 1) buffer B { "
          "vec4 b; }; "
          "void main() { b = v; }",
          "layout(std430, set = 1, binding = 0) buffer B { vec4 b; }; void main() { b = vec4(1); }"})
        EXPECT_THROW(reflect(std::string("layout(local_size_x = 1) in;\n") + resource), CompileError)
            << resource;
}

} // namespace
} // namespace gnomon
