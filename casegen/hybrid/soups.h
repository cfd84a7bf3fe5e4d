// Scenes that no modeller would make, over a ground that receives their shadows.
#pragma once

#include "casegen/random.h"
#include "runtime/pipeline/view.h"

namespace gnomon::hybrid {

/// 8 to 300 triangles: overlapping, intersecting, shared edges wound either way, duplicates, fans of three
/// and more round an edge, walls, far away, slivers, tiny and huge. The same for the same numbers.
Scene soup(std::uint64_t seed, std::uint64_t index);

/// A camera on the ground's middle, a light from anywhere above or along an axis.
Camera soup_camera(std::uint64_t seed, std::uint64_t index);
Light soup_light(std::uint64_t seed, std::uint64_t index);

/// Map size, fit and where rays begin.
ViewSettings soup_settings(std::uint64_t index);

} // namespace gnomon::hybrid
