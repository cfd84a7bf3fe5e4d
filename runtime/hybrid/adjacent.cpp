#include "runtime/hybrid/adjacent.h"

#include "runtime/adjacency.h"

namespace gnomon {

std::vector<std::uint32_t> with_far_corners(const Scene& scene) {
    const Adjacency adjacency = make_adjacency(scene);
    const auto corner = [&](std::uint32_t t, std::uint32_t k) {
        return scene.triangles[t][static_cast<int>(k % 3)];
    };
    std::vector<std::uint32_t> indices;
    indices.reserve(6 * scene.triangles.size());
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
        for (std::uint32_t e = 0; e < 3; ++e) {
            const std::uint32_t beyond = adjacency.next[3 * t + e];
            indices.push_back(corner(t, e));
            indices.push_back(beyond == 3 * t + e ? corner(t, e) : corner(beyond / 3, beyond % 3 + 2));
        }
    return indices;
}

std::vector<std::uint32_t> ring_bits(const Scene& scene, glm::vec3 towards_light) {
    const std::vector<std::uint32_t> away = facing_away(scene, towards_light);
    const std::vector<Neighbours> found = neighbours(scene, make_adjacency(scene), away);
    std::vector<std::uint32_t> bits;
    bits.reserve(found.size());
    for (std::uint32_t t = 0; t < found.size(); ++t)
        bits.push_back(found[t].away | static_cast<std::uint32_t>(found[t].inner) << 3 |
                       (is_set(away, t) ? 64u : 0u));
    return bits;
}

} // namespace gnomon
