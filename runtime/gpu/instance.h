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

/// All devices, in the loader's order. Throws Error with the remedy if no Vulkan loader or no driver is
/// installed.
std::vector<DeviceInfo> list_devices();

} // namespace gnomon::gpu
