// Scenes whose shadows can be worked out by hand.
#pragma once

#include "casegen/plain_scenes.h"

namespace gnomon::testing {

using gnomon::add_box, gnomon::add_quad, gnomon::ground;

/// A box of 2 x 1.5 x 1 on a square of 12 x 12.
Scene box_on_ground();

/// Every coordinate times `factor`.
Scene scaled(Scene scene, float factor);

} // namespace gnomon::testing
