// What the passes that shrink triangles by adjacency read besides the scene. None depends on the map's size.
#pragma once

#include "runtime/scene.h"

#include <cstdint>
#include <vector>

namespace gnomon {

/// Six indices a triangle: its corners, and behind each the far corner of the triangle beyond the edge that
/// begins there; without one the corner itself again. Where more than two triangles meet at an edge it is the
/// next by number: the thesis does not say, and its counts are met by any.   [thesis ch. 4; hybrid.md,
/// convention 10]
std::vector<std::uint32_t> with_far_corners(const Scene& scene);

/// One a triangle, as kernels/hybrid/one_ring.vert reads them: Neighbours of runtime/adjacency.h, and whether
/// it faces away from a directional light itself.
std::vector<std::uint32_t> ring_bits(const Scene& scene, glm::vec3 towards_light);

} // namespace gnomon
