// The insides of the runtime's objects, for the files of runtime/gpu alone.
#pragma once

#include "runtime/gpu/device.h"
#include "runtime/gpu/vulkan.h"

namespace gnomon::gpu {

struct Buffer::Impl {
    Owned<VkDeviceMemory> memory; // destroyed after the buffer it backs
    Owned<VkBuffer> handle;
    std::size_t size = 0;
    std::byte* mapped = nullptr; // where the host sees it; null: copies go through a staging buffer
};

/// Shader interface: what descriptors a pipeline takes, and the one set that holds them.
struct Bindings {
    Owned<VkDescriptorSetLayout> set_layout;
    Owned<VkPipelineLayout> pipeline_layout;
    Owned<VkDescriptorPool> pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::vector<std::uint32_t> numbers;
    std::uint32_t constant_bytes = 0;
};

struct Kernel::Impl {
    glsl::Reflection reflection;
    std::string name;
    Bindings bindings;
    Owned<VkPipeline> pipeline;
};

struct Target::Impl {
    Owned<VkDeviceMemory> memory;
    Owned<VkImage> image;
    Owned<VkImageView> view;
    std::uint32_t width = 0, height = 0;
    Format format = Format::rgba32_float;
};

struct Raster::Impl {
    std::string name;
    Bindings bindings;
    Owned<VkPipeline> pipeline;
    RasterState state;
    VkShaderStageFlags stages = 0;
};

Owned<VkShaderModule> shader_module(const std::shared_ptr<Context>& context, const glsl::Spirv& words);

Bindings make_bindings(const std::shared_ptr<Context>& context, std::vector<std::uint32_t> numbers,
                       std::uint32_t constant_bytes, VkShaderStageFlags stages);

/// Points the set at `buffers`, and at what is always bound behind them, and records binding it and the
/// constants. Throws Error on a wrong number of either, and if the stages draw, write and may not.
void record_bindings(Context& context, VkCommandBuffer commands, VkPipelineBindPoint point,
                     const Bindings& bindings, std::span<const VkBuffer> buffers,
                     std::span<const std::byte> constants, VkShaderStageFlags stages,
                     const std::string& name);

/// Everything written before is seen by everything after, the host included.
void full_barrier(VkCommandBuffer commands);

} // namespace gnomon::gpu
