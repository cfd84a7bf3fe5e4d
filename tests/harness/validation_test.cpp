// The layer that every test on the device relies upon is on, and is heard.
#include "runtime/gpu/validation.h"
#include "runtime/gpu/vulkan.h"

#include "tests/support/device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

TEST(validation_layer, objects_to_a_wrong_call) {
    testing::shared_device();
    const VkPhysicalDevice device = gpu::physical_devices(gpu::instance(true)).at(0).handle;
    EXPECT_EQ(gpu::take_validation_messages(), std::vector<std::string>{});
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, {}}; // another's type
    vkGetPhysicalDeviceProperties2(device, &properties);
    EXPECT_THAT(gpu::take_validation_messages(), Contains(HasSubstr("VkPhysicalDeviceProperties2-sType")));
    EXPECT_EQ(gpu::take_validation_messages(), std::vector<std::string>{}) << "taken is taken";
}

} // namespace
} // namespace gnomon
