#include "cli/commands.h"

#include <fmt/format.h>

namespace gnomon::cli {

void add_devices(CLI::App& app, Common&) {
    CLI::App* verb = app.add_subcommand("devices", "list the Vulkan devices that --device takes");
    verb->callback([] {
        for (const gpu::DeviceInfo& device : gpu::list_devices())
            fmt::print("{}: {}\n   {}, Vulkan {}, {}\n", device.index, device.name, device.kind,
                       device.vulkan, device.driver);
    });
}

} // namespace gnomon::cli
