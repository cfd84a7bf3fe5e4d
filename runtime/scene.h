// A scene is a triangle soup with normals: what every pass and the ray tracer read.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gnomon {

/// Axis-aligned box in world units. `lower` > `upper` means empty.
struct Box {
    glm::vec3 lower{1e30f}, upper{-1e30f};

    void include(glm::vec3 point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
    glm::vec3 centre() const { return 0.5f * (lower + upper); }
    float diagonal() const { return glm::length(upper - lower); }
};

/// Triangles (three indices each) over vertices with positions (world units) and unit normals.
/// Winding is not to be relied upon; normals may be interpolated or flat.
struct Scene {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; // one per position
    std::vector<glm::uvec3> triangles;
    std::vector<std::string> warnings; // what was mended while loading, one line each

    Box bounds() const;
};

/// Reads glTF (.gltf, .glb), OBJ or PLY through Assimp, flattened into one mesh in world space. Missing
/// normals are made flat (each triangle gets its own vertices); a normal of no length becomes that of a
/// triangle at its vertex. Zero-area triangles are dropped and counted in `warnings`; points, lines and
/// unused vertices are left out. Throws Error naming the file: missing, unknown kind, malformed, no triangles
/// (left), a position that is NaN or infinite (which one), indices out of range, coordinates beyond 1e15 in
/// magnitude.
Scene load_scene(const std::filesystem::path& path);

} // namespace gnomon
