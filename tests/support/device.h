// The device that a test program's tests share, with the validation layer on.
#pragma once

#include "casegen/standalone.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gnomon::testing {

inline gpu::DeviceOptions validated() { return {.name = {}, .validation = true, .time_limit = 60}; }

gpu::Device& shared_device();
void close_shared_device();

/// Result words of a kernel of the catalogue over `records`, after requiring that it wrote them all and
/// nothing else.
std::vector<std::uint32_t> run_kernel(const std::string& name, const Records& records);

} // namespace gnomon::testing
