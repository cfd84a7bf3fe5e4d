// Devices, buffers and dispatches.
#include "runtime/gpu/device.h"

#include "runtime/error.h"
#include "tests/support/device.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using testing::shared_device;
using testing::validated;

gpu::Kernel double_it() {
    return shared_device().kernel(glsl::compile({".", {}}, R"(layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer In { float values[]; };
layout(std430, binding = 1) writeonly buffer Out { float results[]; };
layout(push_constant) uniform Constants { uint count; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < count) results[i] = 2.0 * values[i];
})",
                                                "double_it", glsl::Stage::compute),
                                  "double_it");
}

TEST(device, runs_a_kernel_over_as_many_threads_as_asked) {
    gpu::Device& device = shared_device();
    gpu::Kernel kernel = double_it();
    for (const std::uint32_t count : {1u, 63u, 64u, 65u, 100000u}) {
        std::vector<float> values(count);
        for (std::uint32_t i = 0; i < count; ++i) values[i] = static_cast<float>(i);
        const gpu::Buffer in = device.upload(values);
        gpu::Buffer out = device.upload(std::vector<float>(count, -1.0f));
        const double nanoseconds =
            device.run(kernel, {&in, &out}, {.threads = {count, 1, 1}, .constants = gpu::bytes_of(count)});
        EXPECT_GT(nanoseconds, 0);
        const std::vector<float> results = device.read<float>(out);
        for (std::uint32_t i = 0; i < count; ++i)
            ASSERT_EQ(results[i], 2 * values[i]) << i << " of " << count;
    }
}

TEST(device, buffers_keep_their_bytes) {
    gpu::Device& device = shared_device();
    gpu::Buffer buffer = device.allocate(16);
    EXPECT_EQ(buffer.size(), 16u);
    const std::array<std::uint32_t, 4> all{1, 2, 3, 4};
    device.write(buffer, std::as_bytes(std::span(all)));
    const std::uint32_t seven = 7;
    device.write(buffer, gpu::bytes_of(seven), 8);
    EXPECT_EQ(device.read<std::uint32_t>(buffer), (std::vector<std::uint32_t>{1, 2, 7, 4}));
    EXPECT_THAT(error_of([&] { device.write(buffer, gpu::bytes_of(seven), 13); }), HasSubstr("buffer of 16"));
    std::uint32_t word = 0;
    EXPECT_THAT(error_of([&] { device.read(buffer, std::as_writable_bytes(std::span(&word, 1)), 16); }),
                HasSubstr("buffer of 16"));
}

TEST(device, says_what_a_dispatch_lacks) {
    gpu::Device& device = shared_device();
    gpu::Kernel kernel = double_it();
    const std::uint32_t one = 1;
    const gpu::Buffer buffer = device.allocate(4);
    EXPECT_THAT(error_of([&] { device.run(kernel, {&buffer}, {.constants = gpu::bytes_of(one)}); }),
                HasSubstr("double_it binds 2 buffers, 1 were given"));
    EXPECT_THAT(error_of([&] {
                    device.run(kernel, {&buffer, &buffer}, {});
                }),
                HasSubstr("4 bytes of push constants"));
    EXPECT_THAT(error_of([&] {
                    device.run(kernel, {&buffer, &buffer},
                               {.threads = {0xffffffffu, 1, 1}, .constants = gpu::bytes_of(one)});
                }),
                HasSubstr("4294967295 threads are more than"));
}

TEST(device, lists_what_there_is_when_asked_for_what_there_is_not) {
    const std::string name = shared_device().info().name;
    for (const char* wanted : {"no such device", "99", "-1"})
        EXPECT_THAT(error_of([&] { gpu::Device device({.name = wanted}); }), HasSubstr(name)) << wanted;
}

TEST(device, is_found_by_index_and_by_part_of_its_name_in_any_case) {
    for (const gpu::DeviceInfo& info : gpu::list_devices()) {
        gpu::DeviceOptions options = validated();
        options.name = std::to_string(info.index);
        EXPECT_EQ(gpu::Device(options).info().name, info.name);
    }
    gpu::DeviceOptions options = validated();
    options.name = "LLVMpipe";
    EXPECT_EQ(gpu::Device(options).info().kind, "CPU");
}

TEST(device, says_how_much_memory_was_too_much) {
    EXPECT_THAT(error_of([] { shared_device().allocate(std::size_t{1} << 42); }), HasSubstr("4194304.0 MiB"));
    const gpu::Buffer still_works = shared_device().allocate(1024);
    EXPECT_EQ(still_works.size(), 1024u);
}

} // namespace
} // namespace gnomon
