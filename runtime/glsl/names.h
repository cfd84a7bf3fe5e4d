// What a shader is called, as against what it does.
#pragma once

#include "runtime/glsl/compiler.h"

namespace gnomon::glsl {

/// The words without source, names, strings and lines: two that are the same words then are the same code.
Spirv without_names(const Spirv& words);

} // namespace gnomon::glsl
