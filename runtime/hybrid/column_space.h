// The light's space that columns live in, from the very file that the shaders include.
#pragma once

#include "runtime/pipeline/frame.h"
#include "runtime/scene.h"

#include <vector>

namespace gnomon {
namespace shared {
#include "kernels/hybrid/column_space.glslh"
} // namespace shared

/// For a directional light's frame: the map's texels, seen from amid `receivers`, the box of the points where
/// shadow rays start; and margins that cover every rounding between here, the shaders and the ray tracer.
shared::ColumnSpace column_space(const shared::Frame& frame, const Box& receivers);

/// Every vertex in column space, and how far it is from the space's centre in world units. Computed in double
/// and rounded once, so that corners are as exact as float32 holds; on all cores.
std::vector<glm::vec4> column_places(const shared::ColumnSpace& space, const Scene& scene);

} // namespace gnomon
