#include "runtime/gpu/vulkan.h"

#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/gpu/validation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <mutex>

namespace gnomon::gpu {
namespace {

constexpr const char* no_driver =
    "install one: apt-get install mesa-vulkan-drivers (lavapipe, runs on any CPU)";

std::once_flag prepared;

/// Mesa compiles a shader at its first dispatch and remembers the machine code: beside our own cache, so that
/// one folder holds all of it and a cold start can be measured.
void pin_mesa_cache() {
    const std::filesystem::path folder = cache_directory() / "mesa";
    std::error_code ignored; // a cache that cannot be made costs time only
    std::filesystem::create_directories(folder, ignored);
    setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
}

void open_lavapipe_only() {
    for (const char* chosen : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"})
        if (std::getenv(chosen)) return;
    const std::filesystem::path folder =
        "/usr/share/vulkan/icd.d"; // where Debian's mesa-vulkan-drivers puts it
    std::error_code missing;
    std::string files; // one per architecture: the loader passes over those it cannot open
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
        if (entry.path().filename().string().starts_with("lvp_icd.")) {
            if (!files.empty()) files += ':';
            files += entry.path().string();
        }
    if (!files.empty()) setenv("VK_DRIVER_FILES", files.c_str(), 1);
}

void load_vulkan_once() {
    static std::once_flag once;
    prepare_process(false);
    std::call_once(once, [] {
        if (volkInitialize() != VK_SUCCESS)
            throw Error("no Vulkan loader (libvulkan.so.1) on this machine: apt-get install libvulkan1");
    });
}

bool has_layer(const char* name) {
    std::uint32_t count = 0;
    check(vkEnumerateInstanceLayerProperties(&count, nullptr), "listing Vulkan's layers");
    std::vector<VkLayerProperties> layers(count);
    check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "listing Vulkan's layers");
    return std::ranges::any_of(layers, [&](const auto& l) { return std::string_view(l.layerName) == name; });
}

VkInstance create_instance(bool validation) {
    load_vulkan_once();
    constexpr const char* layer = "VK_LAYER_KHRONOS_validation";
    if (validation && !has_layer(layer))
        throw Error("Vulkan's validation layer is missing: apt-get install vulkan-validationlayers");
    std::uint32_t loader = 0;
    check(vkEnumerateInstanceVersion(&loader), "asking the Vulkan loader's version");
    if (loader < VK_API_VERSION_1_3)
        throw Error("the Vulkan loader is {}.{}, 1.3 is needed: update libvulkan1",
                    VK_API_VERSION_MAJOR(loader), VK_API_VERSION_MINOR(loader));
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "gnomon";
    application.apiVersion = VK_API_VERSION_1_3;
    const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    info.enabledLayerCount = info.enabledExtensionCount = validation ? 1 : 0;
    info.ppEnabledLayerNames = &layer;
    info.ppEnabledExtensionNames = &extension;
    VkInstance handle = VK_NULL_HANDLE;
    const VkResult result = vkCreateInstance(&info, nullptr, &handle);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        throw Error("no Vulkan driver on this machine; {}", no_driver);
    check(result, "creating the Vulkan instance");
    static std::array<std::once_flag, 2> loaded; // the loader's functions serve every instance
    std::call_once(loaded[validation ? 1 : 0], [&] { volkLoadInstance(handle); });
    if (validation) collect_validation_messages(handle);
    return handle;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

const char* kind_name(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return "CPU";
    default:
        return "other";
    }
}

std::string version_text(std::uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

} // namespace

void prepare_process(bool default_device_only) {
    std::call_once(prepared, [&] {
        pin_mesa_cache();
        setenv("NODEVICE_SELECT", "1",
               0); // Mesa's layer that sorts devices: we choose ourselves, it takes 1 ms
        if (default_device_only) open_lavapipe_only();
    });
}

VkInstance instance(bool validation, bool isolated) {
    static std::mutex mutex;
    static std::array<VkInstance, 2> instances{};
    const std::scoped_lock lock(mutex);
    if (isolated) return create_instance(validation);
    VkInstance& slot = instances[validation ? 1 : 0];
    if (slot == VK_NULL_HANDLE) slot = create_instance(validation);
    return slot;
}

std::vector<PhysicalDevice> physical_devices(VkInstance from) {
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(from, &count, nullptr), "listing Vulkan devices");
    std::vector<VkPhysicalDevice> handles(count);
    check(vkEnumeratePhysicalDevices(from, &count, handles.data()), "listing Vulkan devices");
    if (handles.empty()) throw Error("no Vulkan device on this machine; {}", no_driver);
    std::vector<PhysicalDevice> devices;
    for (VkPhysicalDevice handle : handles) {
        VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
        VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
        vkGetPhysicalDeviceProperties2(handle, &properties);
        const VkPhysicalDeviceProperties& p = properties.properties;
        devices.push_back(
            {handle,
             {static_cast<int>(devices.size()), p.deviceName, kind_name(p.deviceType),
              fmt::format("{} {}", driver.driverName, driver.driverInfo), version_text(p.apiVersion)}});
    }
    return devices;
}

std::vector<DeviceInfo> list_devices() {
    std::vector<DeviceInfo> list;
    for (PhysicalDevice& device : physical_devices(instance(false))) list.push_back(std::move(device.info));
    return list;
}

PhysicalDevice choose_device(VkInstance from, const std::string& wanted) {
    std::vector<PhysicalDevice> devices = physical_devices(from);
    std::vector<std::string> offered;
    for (const PhysicalDevice& device : devices)
        offered.push_back(fmt::format("{}: {}", device.info.index, device.info.name));
    const std::string list = fmt::format("{}", fmt::join(offered, "; "));

    int index = 0;
    const char* end = wanted.data() + wanted.size();
    if (const auto [stop, error] = std::from_chars(wanted.data(), end, index);
        error == std::errc{} && stop == end) {
        if (index < 0 || index >= static_cast<int>(devices.size()))
            throw Error("no device number {}; --device takes one of {}", wanted, list);
        return devices[static_cast<std::size_t>(index)];
    }
    const std::string part = lower(wanted.empty() ? "llvmpipe" : wanted);
    for (PhysicalDevice& device : devices)
        if (lower(device.info.name).find(part) != std::string::npos ||
            lower(device.info.driver).find(part) != std::string::npos)
            return std::move(device);
    if (wanted.empty())
        throw Error(
            "lavapipe, the default device, is not installed: apt-get install mesa-vulkan-drivers, or choose "
            "--device from {}",
            list);
    throw Error("no device is called \"{}\"; --device takes one of {}", wanted, list);
}

} // namespace gnomon::gpu
