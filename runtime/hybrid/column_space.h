// The light's space that columns live in, from the very file that the shaders include.
#pragma once

#include "runtime/pipeline/frame.h"
#include "runtime/scene.h"

#include <vector>

namespace gnomon {
namespace shared {
#include "kernels/hybrid/column_space.glslh"
} // namespace shared

/// For a directional light's frame over a scene: the map's texels, margins that cover every rounding between
/// here, the shaders and the ray tracer, and tmin.
shared::ColumnSpace column_space(const shared::Frame& frame, const Box& bounds);

/// Every vertex in column space (w is 0). Computed in double and rounded once, so that corners are as exact
/// as float32 holds; on all cores.
std::vector<glm::vec4> column_places(const shared::ColumnSpace& space, const Scene& scene);

} // namespace gnomon
