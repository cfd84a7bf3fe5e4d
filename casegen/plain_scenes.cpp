#include "casegen/plain_scenes.h"

namespace gnomon {

void add_quad(Scene& scene, const std::array<glm::vec3, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[3] - corners[0]));
    for (const glm::vec3 corner : corners) {
        scene.positions.push_back(corner);
        scene.normals.push_back(normal);
    }
    scene.triangles.emplace_back(first, first + 1, first + 2);
    scene.triangles.emplace_back(first, first + 2, first + 3);
}

void add_box(Scene& scene, glm::vec3 lower, glm::vec3 upper) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            std::array<glm::vec3, 4> corners{};
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i][axis] = far ? upper[axis] : lower[axis];
                corners[i][u] = i == 1 || i == 2 ? upper[u] : lower[u];
                corners[i][v] = i >= 2 ? upper[v] : lower[v];
            }
            add_quad(scene, corners);
        }
}

Scene ground(float half_side, int cells) {
    Scene scene;
    scene.name = "ground";
    const auto line = [&](int i) {
        return half_side * (2 * static_cast<float>(i) / static_cast<float>(cells) - 1);
    };
    for (int x = 0; x < cells; ++x)
        for (int z = 0; z < cells; ++z)
            add_quad(scene, {glm::vec3(line(x), 0, line(z)), glm::vec3(line(x), 0, line(z + 1)),
                             glm::vec3(line(x + 1), 0, line(z + 1)), glm::vec3(line(x + 1), 0, line(z))});
    return scene;
}

} // namespace gnomon
