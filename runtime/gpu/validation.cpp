#include "runtime/gpu/validation.h"

#include "runtime/gpu/vulkan.h"

#include <mutex>
#include <utility>

namespace gnomon::gpu {
namespace {

std::mutex mutex;
std::vector<std::string> messages;

VkBool32 collect(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                 const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    const std::scoped_lock lock(mutex);
    messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

} // namespace

std::vector<std::string> take_validation_messages() {
    const std::scoped_lock lock(mutex);
    return std::exchange(messages, {});
}

void collect_validation_messages(VkInstance instance) {
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = collect;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE; // lives as long as its instance
    check(vkCreateDebugUtilsMessengerEXT(instance, &info, nullptr, &messenger),
          "listening to the validation layer");
}

} // namespace gnomon::gpu
