// A kernel alone on the device as casegen/standalone.h runs it, with text around it and one buffer more: for
// those who change a kernel's text so that it tells more than its results.
#pragma once

#include "casegen/standalone.h"

#include <cstdint>
#include <string>

namespace gnomon {

/// The binding of the storage buffer that an addition declares.
constexpr std::uint32_t added_binding = 3;

struct Addition {
    std::string declarations; ///< before the kernel
    std::string at_end;       ///< of main(), where `index` is the record's number
};

std::string standalone_source(const Case& c, const Addition& addition);

/// Throws CompileError as the other one does.
glsl::Spirv compile_standalone(const Case& c, const glsl::Sources& sources, const Addition& addition);

/// `added` holds zeros when either of the two runs begins, so that it ends as the second one, over all
/// records, leaves it. Throws KernelTimeout.
Outputs run_standalone(gpu::Device& device, gpu::Kernel& kernel, const Case& c, const Records& records,
                       gpu::Buffer& added);

} // namespace gnomon
