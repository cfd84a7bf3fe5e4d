#include "casegen/hybrid/soups.h"

#include "casegen/plain_scenes.h"

#include <array>
#include <cmath>

namespace gnomon::hybrid {
namespace {

using glm::vec3;

float any(Random& random) { return static_cast<float>(2 * random.unit() - 1); }
vec3 direction(Random& random) { return glm::normalize(vec3(any(random), any(random), any(random)) + 1e-3f); }
vec3 above(Random& random) { return {1.6f * any(random), 0.7f + 0.65f * any(random), 1.6f * any(random)}; }

/// Triangles over shared vertices.
struct Maker {
    Scene& scene;
    Random& random;

    std::uint32_t vertex(vec3 p) {
        scene.positions.push_back(p);
        scene.normals.emplace_back(0, 1, 0);
        return static_cast<std::uint32_t>(scene.positions.size() - 1);
    }
    void face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto& p = scene.positions;
        if (glm::cross(p[b] - p[a], p[c] - p[a]) == vec3(0)) return; // as loading does
        scene.triangles.emplace_back(a, b, c);
    }
    void triangle(vec3 a, vec3 b, vec3 c) { face(vertex(a), vertex(b), vertex(c)); }

    void loose(float size) {
        const vec3 at = above(random);
        triangle(at, at + size * direction(random), at + size * direction(random));
    }
    /// A grid of cells, crumpled; every so often one is missing or wound the other way.
    void sheet(bool consistent) {
        const vec3 at = above(random), u = 0.25f * direction(random), v = 0.25f * direction(random);
        const float crumpled = random.chance(0.5) ? 0.0f : 0.12f;
        constexpr std::uint32_t n = 4;
        std::array<std::uint32_t, n * n> grid{};
        for (std::uint32_t i = 0; i < n * n; ++i)
            grid[i] = vertex(at + u * static_cast<float>(i % n) + v * static_cast<float>(i / n) +
                             crumpled * direction(random));
        for (std::uint32_t y = 0; y + 1 < n; ++y)
            for (std::uint32_t x = 0; x + 1 < n; ++x) {
                if (random.chance(0.07)) continue;
                const std::uint32_t a = grid[y * n + x], b = grid[y * n + x + 1], c = grid[(y + 1) * n + x],
                                    d = grid[(y + 1) * n + x + 1];
                const bool turned = !consistent && random.chance(0.5);
                turned ? face(a, c, b) : face(a, b, c);
                face(b, d, c);
            }
    }
    /// Three to six triangles round one edge; or round one vertex, not all the way.
    void fan(bool round_edge) {
        const vec3 at = above(random);
        const std::uint32_t a = vertex(at), b = vertex(at + 0.8f * direction(random));
        const auto count = static_cast<std::uint32_t>(random.between(3, 6));
        if (round_edge) {
            for (std::uint32_t i = 0; i < count; ++i) face(a, b, vertex(at + 0.7f * direction(random)));
            return;
        }
        const vec3 u = 0.6f * direction(random), v = 0.6f * direction(random);
        std::uint32_t last = vertex(at + u);
        for (std::uint32_t i = 1; i < count; ++i) {
            const float angle = static_cast<float>(i);
            const std::uint32_t next = vertex(at + std::cos(angle) * u + std::sin(angle) * v);
            face(a, last, next);
            last = next;
        }
    }
    /// Two triangles folded over an edge, at any angle, down to flat on each other.
    void fold() {
        const vec3 at = above(random), edge = 0.8f * direction(random), out = 0.8f * direction(random);
        const vec3 lift = std::exp2(-10.0f * static_cast<float>(random.unit())) * direction(random);
        const std::uint32_t a = vertex(at), b = vertex(at + edge);
        face(a, b, vertex(at + out));
        face(b, a, vertex(at + 0.5f * edge + out + lift));
    }
    void sliver() {
        const vec3 at = above(random), along = 1.5f * direction(random);
        const float thin = std::exp2(-22.0f * static_cast<float>(random.unit()));
        triangle(at, at + along, at + any(random) * along + thin * direction(random));
    }
    void wall() {
        const vec3 at = above(random);
        const bool along_x = random.chance(0.5);
        const vec3 side(along_x ? 0.7f : 0.0f, 0, along_x ? 0.0f : 0.7f);
        add_quad(scene, {at, at + side, at + side + vec3(0, 0.5f, 0), at + vec3(0, 0.5f, 0)});
    }
    void again() { // the last ones once more, some wound the other way
        const std::size_t count = scene.triangles.size();
        for (std::size_t i = count - std::min<std::size_t>(count, 4); i < count; ++i) {
            const glm::uvec3 t = scene.triangles[i];
            const auto& p = scene.positions;
            const std::array<vec3, 3> corners{p[t.x], p[t.y], p[t.z]};
            if (random.chance(0.5))
                triangle(corners[0], corners[1], corners[2]);
            else
                triangle(corners[1], corners[0], corners[2]);
        }
    }
    void add() {
        switch (random.below(13)) {
        case 0:
            return loose(1.0f);
        case 1:
            return loose(0.02f);
        case 2:
            return loose(3e-4f);
        case 3:
            return sheet(true);
        case 4:
            return sheet(false);
        case 5:
            return fan(true);
        case 6:
            return fan(false);
        case 7:
            return fold();
        case 8:
            return sliver();
        case 9:
            return wall();
        case 10:
            return again();
        case 11: // huge, over part of all
            return triangle(above(random) + 40.0f * vec3(1, 0, 0), above(random) - 30.0f * vec3(0, 0, 1),
                            above(random) + 30.0f * vec3(-1, 0, 1));
        default: // far outside of the map
            triangle(30.0f * direction(random), 30.0f * direction(random) + vec3(0, 40, 0),
                     30.0f * direction(random) + vec3(0, 20, 0));
        }
    }
};

} // namespace

Scene soup(std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index);
    Scene scene = ground(2, 1 + static_cast<int>(random.below(3)));
    scene.name = "soup";
    const std::size_t count = index % 3 == 0 ? 8 : index % 3 == 1 ? 60 : 290;
    Maker maker{scene, random};
    while (scene.triangles.size() < count) maker.add();
    return scene;
}

Camera soup_camera(std::uint64_t seed, std::uint64_t index) {
    Random random(seed ^ 0xca3e7a, index);
    Camera camera;
    camera.position =
        vec3(3.0f * any(random), 1.5f + 2.5f * static_cast<float>(random.unit()), 3.0f * any(random));
    camera.direction = vec3(any(random), 0.3f, any(random)) - camera.position;
    camera.fov = 55;
    camera.near = 0.01f;
    camera.far = 60;
    return camera;
}

Light soup_light(std::uint64_t seed, std::uint64_t index) {
    Random random(seed ^ 0x11947, index);
    Light light;
    const std::array axes{vec3(0, -1, 0), vec3(1, 0, 0), vec3(0, 0, -1)};
    light.direction = index % 4 == 3
                          ? axes[random.below(10) < 7 ? 0 : random.below(3)]
                          : vec3(any(random), -0.05f - static_cast<float>(random.unit()), any(random));
    return light;
}

ViewSettings soup_settings(std::uint64_t index) {
    constexpr std::array maps{64, 256, 7, 1000, 1};
    constexpr std::array fits{LightFit::seen_box, LightFit::visible_points, LightFit::camera_frustum};
    ViewSettings settings;
    settings.width = settings.height = 96;
    settings.shadow_map = maps.at(index % maps.size());
    settings.light_fit = fits.at(index % fits.size());
    if (index % 4 == 2) settings.ray_begin = 2e-3f;
    return settings;
}

} // namespace gnomon::hybrid
