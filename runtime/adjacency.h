// What meets what in a triangle soup, which no light and no camera changes: corners at one place are one
// vertex, edges between the same two vertices one edge, and every vertex has a ring of triangles.
#pragma once

#include "runtime/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gnomon {

/// Edge e of triangle t leads from its corner e to corner (e + 1) % 3; as a half-edge its number is 3 t + e.
///
/// Positions are compared by their bits, but -0 is 0: vertices that were split for their normals are one
/// again, T-junctions stay open.
struct Adjacency {
    /// Per vertex of the scene, the number of the place that it lies at: 0, 1, … in the order of first
    /// vertices.
    std::vector<std::uint32_t> place;
    std::uint32_t places = 0;
    /// Per half-edge, the next one between the same two places whichever way it leads, by number, and behind
    /// the last one the first: 3 t + e itself at a border, two that name each other inside a surface, longer
    /// rings where more than two triangles meet. An edge of no length is alone.
    std::vector<std::uint32_t> next;
    /// The triangles with a corner at place p, each once, by number: ring[ring_begin[p]] …
    /// ring[ring_begin[p + 1] - 1].
    std::vector<std::uint32_t> ring_begin, ring;

    std::span<const std::uint32_t> triangles_at(std::uint32_t p) const {
        return std::span(ring).subspan(ring_begin[p], ring_begin[p + 1] - ring_begin[p]);
    }
};

/// In time that grows with the scene's size only, the same for the same scene.
Adjacency make_adjacency(const Scene& scene);

/// Bit t % 32 of word t / 32: whether triangle t shows its back, its corners turning clockwise, to a light in
/// the direction `towards_light` (any length) from everywhere. Triangles seen edge-on and ones without area
/// do not.
std::vector<std::uint32_t> facing_away(const Scene& scene, glm::vec3 towards_light);
/// The same to a light at a point.
std::vector<std::uint32_t> facing_away_from_point(const Scene& scene, glm::vec3 light);

inline bool is_set(std::span<const std::uint32_t> bits, std::uint32_t i) {
    return (bits[i / 32] >> i % 32 & 1) != 0;
}

/// Which triangles at an edge keep it where it is.
enum class Across {
    /// All others there face away, and there is one: the thesis's rule, for edges of any number of triangles.
    facing,
    /// Another one there faces away and lies on the other side of the edge, as the light sees it; of two that
    /// face away these are the ones that name the edge's ends in opposite orders. Folds and duplicates do not
    /// count: behind them there is light.
    sides,
};

/// What kernels/adjacency ask of a triangle that faces away, by its corners 0, 1, 2 as v0, v2, v4.
struct Neighbours {
    std::uint8_t away : 3; ///< bit e: edge e stays
    std::uint8_t
        inner : 3; ///< bit i: all triangles around corner i face away, and each of their edges there stays
};
/// One per triangle; `away` as facing_away has it. Meaningless for triangles that face the light.
std::vector<Neighbours> neighbours(const Scene& scene, const Adjacency& adjacency,
                                   std::span<const std::uint32_t> away, Across across = Across::facing);

} // namespace gnomon
