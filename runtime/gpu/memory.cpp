#include "runtime/error.h"
#include "runtime/gpu/objects.h"

#include <algorithm>

namespace gnomon::gpu {
namespace {

Error out_of_memory(const Context& context, VkDeviceSize bytes) {
    return Error(
        "{} has not enough memory: {:.1f} MiB more were asked for; make the image or shadow map smaller, or "
        "take fewer samples",
        context.info.name, static_cast<double>(bytes) / (1 << 20));
}

Owned<VkBuffer> create_buffer(const std::shared_ptr<Context>& context, std::size_t bytes) {
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    VkBuffer handle = VK_NULL_HANDLE;
    const VkResult result = vkCreateBuffer(context->device, &info, nullptr, &handle);
    if (result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY)
        throw out_of_memory(*context, bytes);
    check(result, "creating a buffer");
    return {context, handle, vkDestroyBuffer};
}

struct Backed {
    Owned<VkDeviceMemory> memory;
    Owned<VkBuffer> buffer;
    VkMemoryPropertyFlags properties = 0;
};

Backed backed_buffer(const std::shared_ptr<Context>& context, std::size_t bytes,
                     VkMemoryPropertyFlags required, VkMemoryPropertyFlags preferred) {
    Backed backed;
    backed.buffer = create_buffer(context, bytes);
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(context->device, backed.buffer, &needs);
    backed.memory = allocate_memory(context, needs, required, preferred, &backed.properties);
    check(vkBindBufferMemory(context->device, backed.buffer, backed.memory, 0), "binding a buffer's memory");
    return backed;
}

std::byte* map(Context& context, VkDeviceMemory memory) {
    void* address = nullptr;
    check(vkMapMemory(context.device, memory, 0, VK_WHOLE_SIZE, 0, &address), "mapping memory");
    return static_cast<std::byte*>(address);
}

constexpr VkMemoryPropertyFlags host_readable = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                                VK_MEMORY_PROPERTY_HOST_COHERENT_BIT |
                                                VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

void copy(Context& context, VkBuffer from, std::size_t from_offset, VkBuffer to, std::size_t to_offset,
          std::size_t bytes) {
    submit(context, [&](VkCommandBuffer commands) {
        const VkBufferCopy region{from_offset, to_offset, bytes};
        vkCmdCopyBuffer(commands, from, to, 1, &region);
        full_barrier(commands);
    });
}

} // namespace

Owned<VkDeviceMemory> allocate_memory(const std::shared_ptr<Context>& context,
                                      const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                                      VkMemoryPropertyFlags preferred, VkMemoryPropertyFlags* got) {
    const VkPhysicalDeviceMemoryProperties& memory = context->memory;
    for (const VkMemoryPropertyFlags wanted : {required | preferred, required}) {
        for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
            const VkMemoryPropertyFlags flags = memory.memoryTypes[type].propertyFlags;
            if ((needs.memoryTypeBits & (1u << type)) == 0 || (flags & wanted) != wanted) continue;
            if (needs.size > memory.memoryHeaps[memory.memoryTypes[type].heapIndex].size) continue;
            VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
            info.allocationSize = needs.size;
            info.memoryTypeIndex = type;
            VkDeviceMemory handle = VK_NULL_HANDLE;
            const VkResult result = vkAllocateMemory(context->device, &info, nullptr, &handle);
            if (result == VK_SUCCESS) {
                if (got) *got = flags;
                return {context, handle, vkFreeMemory};
            }
            if (result != VK_ERROR_OUT_OF_DEVICE_MEMORY && result != VK_ERROR_OUT_OF_HOST_MEMORY)
                check(result, "allocating device memory");
        }
    }
    throw out_of_memory(*context, needs.size);
}

void full_barrier(VkCommandBuffer commands) {
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT;
    barrier.dstAccessMask =
        VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT | VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

Buffer::Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;
Buffer::~Buffer() = default;
std::size_t Buffer::size() const { return impl_ ? impl_->size : 0; }

Buffer Device::allocate(std::size_t bytes) {
    const std::size_t range = max_buffer();
    if (bytes > range)
        throw Error("a buffer of {:.1f} MiB is more than {} binds ({:.1f} MiB); make the image or shadow map "
                    "smaller, "
                    "or take fewer samples",
                    static_cast<double>(bytes) / (1 << 20), context_->info.name,
                    static_cast<double>(range) / (1 << 20));
    // One memory for both sides where the device has it (lavapipe, integrated GPUs); else the device's own.
    Buffer buffer;
    buffer.impl_ = std::make_unique<Buffer::Impl>();
    Backed backed = backed_buffer(context_, std::max<std::size_t>(bytes, 4),
                                  VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, host_readable);
    buffer.impl_->memory = std::move(backed.memory);
    buffer.impl_->handle = std::move(backed.buffer);
    buffer.impl_->size = bytes;
    if ((backed.properties & host_readable) == host_readable)
        buffer.impl_->mapped = map(*context_, buffer.impl_->memory);
    return buffer;
}

void Device::write(Buffer& buffer, std::span<const std::byte> bytes, std::size_t offset) {
    if (offset + bytes.size() > buffer.size())
        throw Error("writing {} bytes at {} into a buffer of {}", bytes.size(), offset, buffer.size());
    if (bytes.empty()) return;
    if (buffer.impl_->mapped) {
        std::memcpy(buffer.impl_->mapped + offset, bytes.data(), bytes.size());
        return;
    }
    const Backed staging =
        backed_buffer(context_, bytes.size(),
                      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, 0);
    std::memcpy(map(*context_, staging.memory), bytes.data(), bytes.size());
    copy(*context_, staging.buffer, 0, buffer.impl_->handle, offset, bytes.size());
}

std::span<const std::byte> Device::mapped(const Buffer& buffer) const {
    if (!buffer.impl_ || !buffer.impl_->mapped) return {};
    return {buffer.impl_->mapped, buffer.impl_->size};
}

void Device::read(const Buffer& buffer, std::span<std::byte> bytes, std::size_t offset) {
    if (offset + bytes.size() > buffer.size())
        throw Error("reading {} bytes at {} from a buffer of {}", bytes.size(), offset, buffer.size());
    if (bytes.empty()) return;
    if (buffer.impl_->mapped) {
        std::memcpy(bytes.data(), buffer.impl_->mapped + offset, bytes.size());
        return;
    }
    const Backed staging = backed_buffer(
        context_, bytes.size(), VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
        VK_MEMORY_PROPERTY_HOST_CACHED_BIT);
    copy(*context_, buffer.impl_->handle, offset, staging.buffer, 0, bytes.size());
    std::memcpy(bytes.data(), map(*context_, staging.memory), bytes.size());
}

} // namespace gnomon::gpu
