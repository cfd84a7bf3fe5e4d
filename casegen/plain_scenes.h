// Pieces of scenes whose shadows can be worked out by hand.
#pragma once

#include "runtime/scene.h"

#include <array>

namespace gnomon {

/// The corners in either sense of rotation.
void add_quad(Scene& scene, const std::array<glm::vec3, 4>& corners);
void add_box(Scene& scene, glm::vec3 lower, glm::vec3 upper);

/// A square in the plane y = 0, of `cells` x `cells` quads.
Scene ground(float half_side, int cells = 1);

} // namespace gnomon
