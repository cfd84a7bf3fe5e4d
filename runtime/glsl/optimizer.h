// Shaders as SPIRV-Tools optimises them: what they cost to execute, as far as their words say, and whether
// two are one.
#pragma once

#include "runtime/glsl/compiler.h"

#include <cstddef>
#include <string>

namespace gnomon::glsl {

/// The shader as `spirv-opt -O` leaves it, without names: two that are the same words then compute the same.
/// Throws Error if SPIRV-Tools cannot.
Spirv optimized(const Spirv& words);

/// Instructions in the bodies of functions once SPIRV-Tools has optimised them as `spirv-opt -O` does:
/// everything inlined, nothing that is never executed. Throws Error if it cannot.
std::size_t optimized_instructions(const Spirv& words);

/// "SPIRV-Tools v2023.1": another one may optimise otherwise.
std::string optimizer_version();

} // namespace gnomon::glsl
