#include "tests/pipeline/scenes.h"

namespace gnomon::testing {

Scene box_on_ground() {
    Scene scene = ground(6);
    add_box(scene, {-1, 0, -0.5f}, {1, 1.5f, 0.5f});
    return scene;
}

Scene scaled(Scene scene, float factor) {
    for (glm::vec3& position : scene.positions) position *= factor;
    return scene;
}

} // namespace gnomon::testing
