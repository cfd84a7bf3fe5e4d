// The built-in scene: nothing to download, and every kind of shadow edge that revectorisation meets.
#pragma once

#include "runtime/scene.h"

namespace gnomon {

/// A picket fence, boxes and thin poles over a ground plane: many slopes, 1-texel strips, corners and holes
/// in the shadow map; the kind of scene that "Optimized Visibility Functions for RBSM" (figure 5) shows. y is
/// up, units are metres, about 10 m across, always the same bits. Flat normals, consistent winding
/// (counter-clockwise seen from outside).
Scene demo_scene();

} // namespace gnomon
