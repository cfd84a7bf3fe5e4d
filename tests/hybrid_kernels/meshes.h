// Small meshes seen from above, the light's side: pillows, open and closed, and all that real models do to
// them. Triangles that turn clockwise face away.
#pragma once

#include "casegen/random.h"
#include "runtime/adjacency.h"
#include "tests/hybrid_kernels/rows.h"

#include <string>
#include <vector>

namespace gnomon::testing {

struct Damage {
    const char* name;
    bool closed = false; ///< with an upper side, which faces the light
    double missing = 0;  ///< share of triangles that are left out,
    double turned = 0;   ///< … wound the other way round,
    double doubled = 0;  ///< … that are there twice,
    double finned = 0;   ///< … with a third triangle at an edge,
    double split = 0;    ///< … cut in two at the middle of an edge, which its neighbour does not know of
};
inline void PrintTo(const Damage& damage, std::ostream* out) { *out << damage.name; }
inline const std::vector<Damage> damages{
    {.name = "open"},
    {.name = "closed", .closed = true},
    {.name = "holes", .missing = 0.15},
    {.name = "inconsistent_winding", .closed = true, .turned = 0.1},
    {.name = "duplicates", .doubled = 0.15},
    {.name = "non_manifold_edges", .finned = 0.15},
    {.name = "t_junctions", .split = 0.15},
    {.name = "everything",
     .closed = true,
     .missing = 0.05,
     .turned = 0.05,
     .doubled = 0.05,
     .finned = 0.05,
     .split = 0.05},
};

/// A grid of size x size squares within [-1, 1]², its inner corners moved about.
inline Scene pillow(const Damage& damage, int size, std::uint64_t seed) {
    Random random(seed);
    Scene scene;
    std::vector<glm::vec3> corners;
    const float step = 1.8f / static_cast<float>(size);
    for (int y = 0; y <= size; ++y)
        for (int x = 0; x <= size; ++x) {
            const bool inner = x > 0 && y > 0 && x < size && y < size;
            const auto shift = [&] {
                return inner ? static_cast<float>(0.5 * random.unit() - 0.25) * step : 0;
            };
            const float at_x = -0.9f + static_cast<float>(x) * step + shift();
            corners.emplace_back(at_x, -0.9f + static_cast<float>(y) * step + shift(), inner ? -1.0f : 0.0f);
        }
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        if (random.chance(damage.turned)) std::swap(b, c);
        const auto first = static_cast<unsigned>(scene.positions.size());
        for (const glm::vec3& corner : {a, b, c}) scene.positions.push_back(corner);
        scene.triangles.emplace_back(first, first + 1, first + 2);
    };
    const auto add_damaged = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        if (random.chance(damage.missing)) return;
        if (random.chance(damage.doubled)) add(a, b, c);
        if (random.chance(damage.finned)) {
            const auto shift = [&] { return static_cast<float>(random.unit() - 0.5) * step; };
            const float x = c.x + shift(), y = c.y + shift();
            add(a, b, {x, y, -0.5f});
        }
        if (random.chance(damage.split)) {
            const glm::vec3 middle = 0.5f * (a + b);
            add(a, middle, c);
            add(middle, b, c);
        } else {
            add(a, b, c);
        }
    };
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const auto at = [&](int i, int j) {
                return corners[static_cast<std::size_t>((y + j) * (size + 1) + x + i)];
            };
            add_damaged(at(0, 0), at(1, 1), at(1, 0)); // clockwise
            add_damaged(at(0, 0), at(0, 1), at(1, 1));
            if (!damage.closed) continue;
            const auto above = [&](int i, int j) {
                glm::vec3 p = at(i, j);
                p.z = -p.z; // the border's corners stay where they are
                return p;
            };
            add_damaged(above(0, 0), above(1, 0), above(1, 1));
            add_damaged(above(0, 0), above(1, 1), above(0, 1));
        }
    scene.normals.assign(scene.positions.size(), glm::vec3(0, 0, 1));
    return scene;
}

} // namespace gnomon::testing
