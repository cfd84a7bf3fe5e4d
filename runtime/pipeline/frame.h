// The structures that host and shaders share, from the very files the shaders include.
#pragma once

#include <glm/glm.hpp>

namespace gnomon::shared {

using glm::mat4;
using glm::uvec4;
using glm::vec4;

#include "kernels/pipeline/frame.glslh"
#include "kernels/pipeline/receiver.glslh"

} // namespace gnomon::shared
