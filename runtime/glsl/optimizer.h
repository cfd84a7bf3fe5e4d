// What a shader costs to execute, as far as its words say.
#pragma once

#include "runtime/glsl/compiler.h"

#include <cstddef>

namespace gnomon::glsl {

/// Instructions in the bodies of functions once SPIRV-Tools has optimised them as `spirv-opt -O` does:
/// everything inlined, nothing that is never executed. Throws Error if it cannot.
std::size_t optimized_instructions(const Spirv& words);

} // namespace gnomon::glsl
