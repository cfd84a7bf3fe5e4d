#include "runtime/adjacency.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace gnomon {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A position's bits, -0 as 0.
using Key = std::array<std::uint32_t, 3>;
Key key_of(glm::vec3 position) {
    const glm::vec3 p = position + 0.0f; // -0 + 0 is 0
    return {std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
            std::bit_cast<std::uint32_t>(p.z)};
}
std::uint64_t hash_of(const Key& key) {
    std::uint64_t h = (std::uint64_t{key[0]} << 32 | key[1]) * 0x9e3779b97f4a7c15ull;
    h = (h ^ h >> 32 ^ key[2]) * 0xd6e8feb86659fd93ull;
    return h ^ h >> 32;
}

/// Numbers places in the order in which they turn up, by a table with open addresses.
void weld(const Scene& scene, Adjacency& adjacency) {
    const std::size_t count = scene.positions.size();
    const std::size_t slots = std::bit_ceil(2 * count + 1);
    std::vector<std::uint32_t> first(slots, none); // the first vertex at the slot's place
    adjacency.place.resize(count);
    for (std::size_t v = 0; v < count; ++v) {
        const Key key = key_of(scene.positions[v]);
        std::size_t slot = hash_of(key) & (slots - 1);
        while (first[slot] != none && key_of(scene.positions[first[slot]]) != key)
            slot = (slot + 1) & (slots - 1);
        if (first[slot] == none) {
            first[slot] = static_cast<std::uint32_t>(v);
            adjacency.place[v] = adjacency.places++;
        } else {
            adjacency.place[v] = adjacency.place[first[slot]];
        }
    }
}

/// A triangle's places.
std::array<std::uint32_t, 3> places_of(const Scene& scene, const Adjacency& adjacency, std::size_t t) {
    const glm::uvec3& corners = scene.triangles[t];
    return {adjacency.place[corners.x], adjacency.place[corners.y], adjacency.place[corners.z]};
}

/// Numbers in buckets 0 … n-1, each bucket in the order of insertion: counted first, then filled.
struct Buckets {
    std::vector<std::uint32_t> begin; ///< n + 1
    explicit Buckets(std::size_t n) : begin(n + 1, 0) {}
    void count(std::size_t bucket) { ++begin[bucket + 1]; }
    std::vector<std::uint32_t> finish() { ///< makes room; returns where each bucket is filled next
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        return {begin.begin(), begin.end() - 1};
    }
};

void make_rings(const Scene& scene, Adjacency& adjacency) {
    Buckets buckets(adjacency.places);
    const auto each = [&](const auto& visit) {
        for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
            const std::array<std::uint32_t, 3> p = places_of(scene, adjacency, t);
            visit(p[0], t);
            if (p[1] != p[0]) visit(p[1], t);
            if (p[2] != p[0] && p[2] != p[1]) visit(p[2], t);
        }
    };
    each([&](std::uint32_t place, std::size_t) { buckets.count(place); });
    std::vector<std::uint32_t> end = buckets.finish();
    adjacency.ring.resize(buckets.begin.back());
    each([&](std::uint32_t place, std::size_t t) {
        adjacency.ring[end[place]++] = static_cast<std::uint32_t>(t);
    });
    adjacency.ring_begin = std::move(buckets.begin);
}

/// A half-edge by its greater place.
struct Spoke {
    std::uint32_t to, half_edge;
    friend auto operator<=>(const Spoke&, const Spoke&) = default;
};

/// Half-edges by their smaller place; within a bucket, ones with the same greater place make a ring.
void link_edges(const Scene& scene, Adjacency& adjacency) {
    const std::size_t count = 3 * scene.triangles.size();
    adjacency.next.resize(count);
    Buckets buckets(adjacency.places);
    const auto each = [&](const auto& visit) {
        for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
            const std::array<std::uint32_t, 3> p = places_of(scene, adjacency, t);
            for (std::size_t e = 0; e < 3; ++e)
                visit(std::min(p[e], p[(e + 1) % 3]), std::max(p[e], p[(e + 1) % 3]),
                      static_cast<std::uint32_t>(3 * t + e));
        }
    };
    each([&](std::uint32_t from, std::uint32_t, std::uint32_t) { buckets.count(from); });
    std::vector<std::uint32_t> end = buckets.finish();
    std::vector<Spoke> spokes(count);
    each([&](std::uint32_t from, std::uint32_t to, std::uint32_t half_edge) {
        spokes[end[from]++] = {to, half_edge};
    });
    for (std::uint32_t from = 0; from < adjacency.places; ++from) {
        const std::span<Spoke> bucket =
            std::span(spokes).subspan(buckets.begin[from], buckets.begin[from + 1] - buckets.begin[from]);
        std::ranges::sort(bucket);
        for (std::size_t i = 0; i < bucket.size();) {
            std::size_t last = i;
            while (last + 1 < bucket.size() && bucket[last + 1].to == bucket[i].to) ++last;
            for (std::size_t k = i; k <= last; ++k) {
                const bool has_length = bucket[k].to != from;
                const std::size_t following = !has_length ? k : k == last ? i : k + 1;
                adjacency.next[bucket[k].half_edge] = bucket[following].half_edge;
            }
            i = last + 1;
        }
    }
}

/// `to_light(corner)`: the direction to the light from a triangle's first corner. In doubles: edges of floats
/// are exact there but for scenes that span more than 2^29 of their resolution.
template <typename ToLight>
std::vector<std::uint32_t> facing_away_by(const Scene& scene, const ToLight& to_light) {
    std::vector<std::uint32_t> bits((scene.triangles.size() + 31) / 32, 0);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const glm::uvec3& corners = scene.triangles[t];
        const glm::dvec3 a(scene.positions[corners.x]), b(scene.positions[corners.y]),
            c(scene.positions[corners.z]);
        if (glm::dot(glm::cross(b - a, c - a), to_light(a)) < 0) bits[t / 32] |= 1u << t % 32;
    }
    return bits;
}

} // namespace

Adjacency make_adjacency(const Scene& scene) {
    Adjacency adjacency;
    weld(scene, adjacency);
    make_rings(scene, adjacency);
    link_edges(scene, adjacency);
    return adjacency;
}

std::vector<std::uint32_t> facing_away(const Scene& scene, glm::vec3 towards_light) {
    const glm::dvec3 towards(towards_light);
    return facing_away_by(scene, [&](const glm::dvec3&) { return towards; });
}

std::vector<std::uint32_t> facing_away_from_point(const Scene& scene, glm::vec3 light) {
    const glm::dvec3 at(light);
    return facing_away_by(scene, [&](const glm::dvec3& corner) { return at - corner; });
}

std::vector<Neighbours> neighbours(const Scene& scene, const Adjacency& adjacency,
                                   std::span<const std::uint32_t> away, Across across) {
    const std::size_t count = scene.triangles.size();
    std::vector<Neighbours> found(count, {0, 0});
    std::vector<std::uint8_t> is_inner(adjacency.places, 1);
    const auto begins_at = [&](std::uint32_t half_edge) {
        return adjacency.place[scene.triangles[half_edge / 3][static_cast<int>(half_edge % 3)]];
    };
    const auto stays = [&](std::uint32_t half_edge) {
        const std::uint32_t begin = begins_at(half_edge);
        std::uint32_t others = 0, facing = 0, opposite = 0;
        for (std::uint32_t other = adjacency.next[half_edge]; other != half_edge;
             other = adjacency.next[other]) {
            ++others;
            if (!is_set(away, other / 3)) continue;
            ++facing;
            if (begins_at(other) != begin) ++opposite;
        }
        return across == Across::facing ? others > 0 && facing == others : opposite > 0;
    };
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::array<std::uint32_t, 3> p = places_of(scene, adjacency, t);
        if (!is_set(away, t)) {
            for (const std::uint32_t place : p) is_inner[place] = 0;
            continue;
        }
        for (std::uint32_t e = 0; e < 3; ++e) {
            if (stays(3 * t + e))
                found[t].away = static_cast<std::uint8_t>((found[t].away | 1u << e) & 7u);
            else
                is_inner[p[e]] = is_inner[p[(e + 1) % 3]] = 0;
        }
    }
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::array<std::uint32_t, 3> p = places_of(scene, adjacency, t);
        for (std::uint32_t i = 0; i < 3; ++i)
            if (is_inner[p[i]] != 0)
                found[t].inner = static_cast<std::uint8_t>((found[t].inner | 1u << i) & 7u);
    }
    return found;
}

} // namespace gnomon
