// Where a frame's receivers are.
#pragma once

#include "runtime/pipeline/resources.h"

#include <optional>

namespace gnomon {

/// Of the pixels that face the light.
struct Seen {
    glm::vec2 lower, upper; ///< in the shadow map, in texels
    Box world;              ///< of the points where their shadow rays start
};

class SeenBounds {
public:
    explicit SeenBounds(Resources& resources)
        : r_(resources), kernel_(resources.kernel("pipeline/seen_bounds.comp")),
          bounds_(resources.device.allocate(std::size_t{resources.tiles()} * sizeof(PerTile))) {}

    /// Nothing if no pixel faces the light. The same bits on any device: least and greatest have no order.
    std::optional<Seen> find() {
        r_.device.run(kernel_, {&r_.frame_buffer, &r_.receivers, &bounds_}, {.threads = {r_.tiles(), 1, 1}});
        Seen seen{glm::vec2(1e30f), glm::vec2(-1e30f), {}};
        const gpu::HostView<PerTile> tiles = r_.device.view<PerTile>(bounds_, r_.tiles());
        for (const PerTile& tile : tiles.values) {
            seen.lower = glm::min(seen.lower, glm::vec2(tile.map));
            seen.upper = glm::max(seen.upper, glm::vec2(tile.map.z, tile.map.w));
            seen.world.lower = glm::min(seen.world.lower, glm::vec3(tile.lower));
            seen.world.upper = glm::max(seen.world.upper, glm::vec3(tile.upper));
        }
        return seen.lower.x > seen.upper.x ? std::nullopt : std::optional(seen);
    }

private:
    struct PerTile {
        glm::vec4 map, lower, upper;
    };
    Resources& r_;
    gpu::Kernel kernel_;
    gpu::Buffer bounds_;
};

} // namespace gnomon
