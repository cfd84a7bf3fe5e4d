// What the validation layer said.
#pragma once

#include <string>
#include <vector>

struct VkInstance_T;

namespace gnomon::gpu {

/// Warnings and errors since the last call, from every device made with validation. Thread-safe.
std::vector<std::string> take_validation_messages();

/// Called once for an instance that was created with the layer.
void collect_validation_messages(VkInstance_T* instance);

} // namespace gnomon::gpu
