// The simplest scene on which a hybrid technique is wrong in the same words.
#pragma once

#include "casegen/fuzz/scene_input.h"
#include "casegen/fuzz/shrink.h"

namespace gnomon::fuzz {

/// Fewer triangles first, by halves, quarters … and one by one; then a smaller image and map; then rounder
/// numbers, all of a kind at once and one by one; and again until nothing helps or `most` candidates were
/// tried. Deterministic. `scene` must fail.
SceneInput shrink_scene(SceneInput scene, const StillFails& still_fails, std::size_t most = 200);

/// Without the triangles from `begin` to `end`, nor the vertices that only they name.
SceneInput without_triangles(const SceneInput& scene, std::size_t begin, std::size_t end);

} // namespace gnomon::fuzz
