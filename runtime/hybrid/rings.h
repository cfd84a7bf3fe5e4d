#pragma once
#include "runtime/scene.h"
#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
namespace gnomon {
inline std::vector<std::uint32_t> half_edge_rings(const Scene& scene) {
    // weld
    std::vector<std::uint32_t> order(scene.positions.size()), weld(order.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 p = scene.positions[i] + 0.0f;
        return std::array{std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                          std::bit_cast<std::uint32_t>(p.z)};
    };
    std::ranges::sort(order, [&](auto a, auto b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
        weld[order[i]] =
            i > 0 && key(order[i]) == key(order[i - 1]) ? weld[order[i - 1]] : static_cast<std::uint32_t>(i);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> edges;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
        for (std::uint32_t e = 0; e < 3; ++e) {
            const std::uint64_t a = weld[scene.triangles[t][static_cast<int>(e)]],
                                b = weld[scene.triangles[t][static_cast<int>((e + 1) % 3)]];
            edges.emplace_back(std::min(a, b) << 32 | std::max(a, b), 3 * t + e);
        }
    std::ranges::sort(edges);
    std::vector<std::uint32_t> next(edges.size());
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i;
        while (j < edges.size() && edges[j].first == edges[i].first) ++j;
        for (std::size_t k = i; k < j; ++k) next[edges[k].second] = edges[k + 1 < j ? k + 1 : i].second;
        i = j;
    }
    return next;
}
} // namespace gnomon
