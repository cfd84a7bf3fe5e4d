// The Vulkan loader, its instance, and the physical devices it offers.
#pragma once

#include <string>
#include <vector>

namespace gnomon::gpu {

struct DeviceInfo {
    int index = 0;      ///< what --device INDEX takes
    std::string name;   ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string kind;   ///< "CPU", "discrete GPU", …
    std::string driver; ///< "llvmpipe Mesa 22.3.6"
    std::string vulkan; ///< "1.3.230"
};

/// Sets the environment that Vulkan's loader and Mesa read: their shader cache goes beside our own, and, if
/// only the default device is wanted and the user has not chosen drivers, the loader opens lavapipe's alone,
/// which saves a third of its start. Call it once, before any thread; a process that does not is prepared,
/// for all devices, when it first uses Vulkan.
void prepare_process(bool default_device_only);

/// All devices, in the loader's order. Throws Error with the remedy if no Vulkan loader or no driver is
/// installed.
std::vector<DeviceInfo> list_devices();

} // namespace gnomon::gpu
