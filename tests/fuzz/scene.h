// Model files, by way of our checks and Assimp: a target for each kind of file.
#pragma once

#include "runtime/scene.h"
#include "runtime/scene_precheck.h"
#include "tests/fuzz/target.h"

#include <cmath>

namespace gnomon::fuzzing {

inline void require_whole(const Scene& scene) {
    REQUIRE(!scene.triangles.empty());
    REQUIRE(scene.positions.size() == scene.normals.size());
    for (const glm::uvec3& triangle : scene.triangles)
        for (int k = 0; k < 3; ++k) REQUIRE(triangle[k] < scene.positions.size());
    for (std::size_t i = 0; i < scene.positions.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            REQUIRE(std::abs(static_cast<double>(scene.positions[i][k])) <= max_coordinate);
        REQUIRE(std::abs(glm::length(scene.normals[i]) - 1) < 1e-3f);
    }
}

/// `file` has the extension of its kind.
inline int read_scene(const InputFile& file, std::string_view bytes) {
    Scene scene;
    if (is_read([&] { scene = load_scene(file.write(bytes)); })) require_whole(scene);
    return 0;
}

} // namespace gnomon::fuzzing
