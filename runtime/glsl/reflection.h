// What a compiled shader needs, read from its words: nobody writes a binding number twice.
#pragma once

#include "runtime/glsl/compiler.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gnomon::glsl {

struct Reflection {
    std::vector<std::uint32_t> storage_buffers; ///< bindings in set 0, ascending
    std::uint32_t push_constant_bytes = 0;
    std::array<std::uint32_t, 3> workgroup_size{1, 1, 1}; ///< compute only
};

/// Throws CompileError if the shader uses a resource that the runtime does not offer (an image, a sampler, a
/// uniform block, a set other than 0), saying which.
Reflection reflect(const Spirv& words, std::string_view name);

} // namespace gnomon::glsl
