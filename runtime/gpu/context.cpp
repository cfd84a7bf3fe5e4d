#include "runtime/error.h"
#include "runtime/gpu/device.h"
#include "runtime/gpu/vulkan.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace gnomon::gpu {
namespace {

std::atomic<bool> some_device_lost = false;

struct QueueFamily {
    std::uint32_t index, timestamp_bits;
};

QueueFamily queue_family(VkPhysicalDevice device, const std::string& name) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i)
        if ((families[i].queueFlags & needed) == needed && families[i].timestampValidBits > 0)
            return {i, families[i].timestampValidBits};
    throw Error("{} has no queue that draws, computes and keeps time: choose another --device", name);
}

} // namespace

bool any_device_lost() { return some_device_lost; }

std::string to_string(VkResult result) {
    switch (result) {
    case VK_SUCCESS:
        return "VK_SUCCESS";
    case VK_TIMEOUT:
        return "VK_TIMEOUT";
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST:
        return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_LAYER_NOT_PRESENT:
        return "VK_ERROR_LAYER_NOT_PRESENT";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
        return "VK_ERROR_EXTENSION_NOT_PRESENT";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "VK_ERROR_FEATURE_NOT_PRESENT";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
        return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_TOO_MANY_OBJECTS:
        return "VK_ERROR_TOO_MANY_OBJECTS";
    default:
        return fmt::format("VkResult {}", static_cast<int>(result));
    }
}

void check(VkResult result, const char* what) {
    if (result == VK_SUCCESS || result == VK_INCOMPLETE) return;
    const bool memory = result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY;
    throw Error("{} failed: {}{}", what, to_string(result),
                memory ? " (ask for a smaller image or shadow map, or fewer samples)" : "");
}

Context::~Context() {
    if (lost || device == VK_NULL_HANDLE) return;
    vkDestroyFence(device, fence, nullptr);
    vkDestroyQueryPool(device, timestamps, nullptr);
    vkDestroyCommandPool(device, commands, nullptr);
    vkDestroyDevice(device, nullptr);
}

Device::Device(const DeviceOptions& options) : context_(std::make_shared<Context>()) {
    Context& c = *context_;
    PhysicalDevice chosen = choose_device(instance(options.validation, options.isolated), options.name);
    c.physical = chosen.handle;
    c.info = std::move(chosen.info);
    c.time_limit = options.time_limit;
    vkGetPhysicalDeviceProperties(c.physical, &c.properties);
    vkGetPhysicalDeviceMemoryProperties(c.physical, &c.memory);
    if (c.properties.apiVersion < VK_API_VERSION_1_3)
        throw Error("{} offers Vulkan {}, 1.3 is needed: update its driver or choose another --device",
                    c.info.name, c.info.vulkan);
    const QueueFamily family = queue_family(c.physical, c.info.name);
    c.queue_family = family.index;
    c.timestamp_bits = family.timestamp_bits;

    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue.queueFamilyIndex = c.queue_family;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    features13.dynamicRendering = VK_TRUE;
    features13.synchronization2 = VK_TRUE;
    features13.maintenance4 = VK_TRUE;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13, {}};
    features.features.robustBufferAccess = VK_TRUE; // a kernel that strays must not take the process with it
    features.features.depthClamp = VK_TRUE;
    VkPhysicalDeviceFeatures offered{};
    vkGetPhysicalDeviceFeatures(c.physical, &offered);
    c.geometry_shaders = offered.geometryShader == VK_TRUE; // Metal's drivers, for one, have none
    features.features.geometryShader = offered.geometryShader;
    features.features.vertexPipelineStoresAndAtomics = offered.vertexPipelineStoresAndAtomics;
    features.features.fragmentStoresAndAtomics = offered.fragmentStoresAndAtomics;
    c.stores_while_drawing =
        offered.vertexPipelineStoresAndAtomics == VK_TRUE && offered.fragmentStoresAndAtomics == VK_TRUE;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    check(vkCreateDevice(c.physical, &info, nullptr, &c.device), "creating the Vulkan device");
    vkGetDeviceQueue(c.device, c.queue_family, 0, &c.queue);

    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = c.queue_family;
    check(vkCreateCommandPool(c.device, &pool, nullptr, &c.commands), "creating a command pool");
    VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = c.commands;
    allocate.commandBufferCount = static_cast<std::uint32_t>(c.command_buffers.size());
    check(vkAllocateCommandBuffers(c.device, &allocate, c.command_buffers.data()), "allocating commands");
    VkQueryPoolCreateInfo queries{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queries.queryCount = 2;
    check(vkCreateQueryPool(c.device, &queries, nullptr, &c.timestamps), "creating timestamps");
    const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    check(vkCreateFence(c.device, &fence, nullptr, &c.fence), "creating a fence");
}

const DeviceInfo& Device::info() const { return context_->info; }
bool Device::has_geometry_shaders() const { return context_->geometry_shaders; }
std::uint32_t Device::max_image_side() const { return context_->properties.limits.maxImageDimension2D; }
std::uint64_t Device::submissions() const { return context_->submissions; }
std::size_t Device::max_buffer() const { return context_->properties.limits.maxStorageBufferRange; }
std::uint32_t Device::max_groups() const { return context_->properties.limits.maxComputeWorkGroupCount[0]; }

VkCommandBuffer begin_commands(Context& context) {
    if (context.lost) throw KernelTimeout("the device hangs in an earlier kernel");
    check(vkResetCommandPool(context.device, context.commands, 0), "resetting commands");
    const std::array<VkCommandBuffer, 2>& both = context.command_buffers;
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    for (VkCommandBuffer commands : both) check(vkBeginCommandBuffer(commands, &begin), "recording commands");
    // The first timestamp is a submission of its own: llvmpipe takes a timestamp when it rasterises the scene
    // that it was recorded in, and would take one in front of a draw or a dispatch too late, at that work's
    // end.
    vkCmdResetQueryPool(both[0], context.timestamps, 0, 2);
    vkCmdWriteTimestamp2(both[0], VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, context.timestamps, 0);
    check(vkEndCommandBuffer(both[0]), "recording commands");
    return both[1];
}

double end_commands(Context& context, VkCommandBuffer commands) {
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, context.timestamps, 1);
    check(vkEndCommandBuffer(commands), "recording commands");
    std::array<VkSubmitInfo, 2> submits{};
    for (std::size_t i = 0; i < submits.size(); ++i) {
        submits[i].sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        submits[i].commandBufferCount = 1;
        submits[i].pCommandBuffers = &context.command_buffers[i];
    }
    // Any of these may be told that the device was reset: a GPU's driver does so to kernels that never end.
    const auto require = [&](VkResult result, const char* what) {
        if (result == VK_TIMEOUT || result == VK_ERROR_DEVICE_LOST) context.lost = some_device_lost = true;
        if (result == VK_TIMEOUT)
            throw KernelTimeout("did not end within {} s: does it loop for ever? (--time-limit allows more)",
                                context.time_limit);
        if (result == VK_ERROR_DEVICE_LOST)
            throw KernelTimeout("the device was lost while it ran: does it loop for ever?");
        check(result, what);
    };
    ++context.submissions;
    require(vkQueueSubmit(context.queue, 2, submits.data(), context.fence), "submitting work");
    const auto limit = static_cast<std::uint64_t>(context.time_limit * 1e9);
    require(vkWaitForFences(context.device, 1, &context.fence, VK_TRUE, limit), "waiting for the device");
    check(vkResetFences(context.device, 1, &context.fence), "resetting the fence");
    std::array<std::uint64_t, 2> ticks{};
    require(vkGetQueryPoolResults(context.device, context.timestamps, 0, 2, sizeof ticks, ticks.data(),
                                  sizeof ticks[0], VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
            "reading timestamps");
    const std::uint64_t valid = ~std::uint64_t{0} >> (64 - context.timestamp_bits); // counters wrap
    return static_cast<double>((ticks[1] - ticks[0]) & valid) *
           static_cast<double>(context.properties.limits.timestampPeriod);
}

} // namespace gnomon::gpu
