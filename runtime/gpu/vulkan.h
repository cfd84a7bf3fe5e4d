// Shared by the files of runtime/gpu alone: the loaded Vulkan functions, and checking of their results.
#pragma once

#include "runtime/gpu/instance.h"

#include <volk.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace gnomon::gpu {

/// "VK_ERROR_DEVICE_LOST" …
std::string to_string(VkResult result);

/// Throws Error "WHAT failed: RESULT (remedy)" unless the result is VK_SUCCESS.
void check(VkResult result, const char* what);

struct PhysicalDevice {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    DeviceInfo info;
};

/// The process's instance, made on first use, with or without the validation layer. Never destroyed: a device
/// may still be hanging in an endless kernel when the process ends. `isolated`: a new one, for a device that
/// must not wait when another one hangs. Throws Error with the remedy.
VkInstance instance(bool validation, bool isolated = false);

/// As list_devices, with handles.
std::vector<PhysicalDevice> physical_devices(VkInstance instance);

/// The device that `wanted` names: an index, or a part of a name (case does not matter). Empty: lavapipe.
/// Throws Error that lists what there is.
PhysicalDevice choose_device(VkInstance instance, const std::string& wanted);

/// What every object of one device shares: it outlives them all.
struct Context {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    std::uint32_t timestamp_bits = 64;
    VkCommandPool commands = VK_NULL_HANDLE;
    std::array<VkCommandBuffer, 2> command_buffers{}; ///< the first timestamp; the work
    VkQueryPool timestamps = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties{};
    VkPhysicalDeviceMemoryProperties memory{};
    DeviceInfo info;
    bool geometry_shaders = false;
    bool stores_while_drawing = false; ///< stages that draw may write to buffers
    std::uint32_t always_at = 0;       ///< Device::bind_always
    VkBuffer always = VK_NULL_HANDLE;
    double time_limit = 0; ///< seconds
    std::uint64_t submissions = 0;
    bool lost = false; ///< hangs in a kernel, or was reset: nothing may be destroyed any more

    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context();
};

/// Owns one Vulkan object of a device.
template <typename T>
class Owned {
public:
    using Destroy = void (*)(VkDevice, T, const VkAllocationCallbacks*);

    Owned() = default;
    Owned(std::shared_ptr<Context> context, T handle, Destroy destroy)
        : context_(std::move(context)), handle_(handle), destroy_(destroy) {}
    Owned(Owned&& other) noexcept { swap(other); }
    Owned& operator=(Owned&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Owned() {
        if (handle_ != VK_NULL_HANDLE && !context_->lost) destroy_(context_->device, handle_, nullptr);
    }
    operator T() const { return handle_; }

private:
    void swap(Owned& other) noexcept {
        std::swap(context_, other.context_);
        std::swap(handle_, other.handle_);
        std::swap(destroy_, other.destroy_);
    }
    std::shared_ptr<Context> context_;
    T handle_ = VK_NULL_HANDLE;
    Destroy destroy_ = nullptr;
};

/// Device memory for one buffer or image. Throws Error that says how much was asked for when there is not
/// enough.
Owned<VkDeviceMemory> allocate_memory(const std::shared_ptr<Context>& context,
                                      const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                                      VkMemoryPropertyFlags preferred, VkMemoryPropertyFlags* got = nullptr);

/// Records with `record(VkCommandBuffer)`, submits, waits at most the time limit; device nanoseconds between
/// the first and the last command. Throws KernelTimeout.
template <typename Record>
double submit(Context& context, Record&& record);

VkCommandBuffer begin_commands(Context& context);
double end_commands(Context& context, VkCommandBuffer commands);

template <typename Record>
double submit(Context& context, Record&& record) {
    VkCommandBuffer commands = begin_commands(context);
    record(commands);
    return end_commands(context, commands);
}

} // namespace gnomon::gpu
