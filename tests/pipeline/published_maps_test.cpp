// What the passes of CRSM and CRSMA draw, texel by texel, against distances from edges in double.
#include "casegen/random.h"
#include "casegen/standalone.h"
#include "runtime/hybrid/adjacent.h"
#include "runtime/hybrid/depth_pass.h"
#include "tests/pipeline/view.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace gnomon::testing {
namespace {

constexpr int side = 96;
const double lambda = std::sqrt(2.0) / side;

/// The light looks down at the square |x|, |z| <= 1 from y = 1 to y = 0; x is across, z is down the rows.
Resources resources_of(const Scene& scene) {
    gpu::Device& device = shared_device();
    shared::Frame frame{};
    frame.light = glm::transpose(glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, 1, 0),
                                           glm::vec4(0, -1, 0, 1), glm::vec4(0, 0, 0, 1)));
    frame.light_depth = {0, -1, 0, 1};
    frame.light_origin = {0, 1, 0, 0};
    frame.size = {1, 1, side, 0};
    Resources r{device,
                kernel_sources(kernels_folder()),
                scene,
                frame,
                static_cast<std::uint32_t>(3 * scene.triangles.size()),
                {},
                {},
                {},
                {},
                {},
                {},
                {},
                {}};
    r.frame_buffer = device.upload(std::span<const shared::Frame>(&frame, 1));
    r.positions = device.upload(scene.positions);
    r.triangles = device.upload(scene.triangles);
    return r;
}

std::vector<float> drawn(const Scene& scene, const DepthStages& stages) {
    Resources r = resources_of(scene);
    DepthPass pass(r, stages, gpu::Cull::front);
    return r.device.read<float>(pass.draw({&r.frame_buffer, &r.positions, &r.triangles}, r.vertices));
}
std::vector<float> plain(const Scene& scene) { return drawn(scene, {"shadow_map.vert", "", ""}); }
std::vector<float> dilated(const Scene& scene) {
    return drawn(scene, {"hybrid/dilated.vert", "", "hybrid/dilated.frag"});
}
std::vector<float> eroded(const Scene& scene) { return drawn(scene, {"hybrid/eroded.vert", "", ""}); }
std::vector<float> adjacent(const Scene& scene) {
    Resources r = resources_of(scene);
    DepthPass pass(r, {"hybrid/adjacency.vert", "hybrid/adjacency.geom", ""}, gpu::Cull::front,
                   gpu::Topology::triangles_with_adjacency);
    const gpu::Buffer six = r.device.upload(with_far_corners(scene));
    return r.device.read<float>(pass.draw({&r.frame_buffer, &r.positions, &six}, 2 * r.vertices));
}
std::vector<float> one_ring(const Scene& scene) {
    Resources r = resources_of(scene);
    DepthPass pass(r, {"hybrid/one_ring.vert", "", ""}, gpu::Cull::front);
    const gpu::Buffer bits = r.device.upload(ring_bits(scene, {0, 1, 0}));
    return r.device.read<float>(
        pass.draw({&r.frame_buffer, &r.positions, &r.triangles, &bits}, 4 * r.vertices));
}

/// A triangle in the light's view, in double: corners, and distances from its edges, positive inside.
struct Seen {
    std::array<glm::dvec3, 3> corner; ///< x, z, depth
    double area;                      ///< twice; positive if it faces away from the light

    Seen(const Scene& scene, glm::uvec3 t) {
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p(scene.positions[t[k]]);
            corner[static_cast<std::size_t>(k)] = {p.x, p.z, 1 - p.y};
        }
        const glm::dvec2 u(corner[1] - corner[0]), v(corner[2] - corner[0]);
        area = u.x * v.y - u.y * v.x;
    }
    double length(std::size_t e) const { return glm::length(glm::dvec2(corner[(e + 1) % 3] - corner[e])); }
    double distance(std::size_t e, glm::dvec2 p) const {
        const glm::dvec2 along(corner[(e + 1) % 3] - corner[e]), from = p - glm::dvec2(corner[e]);
        return (along.x * from.y - along.y * from.x) / length(e) * (area < 0 ? -1 : 1);
    }
    double depth(glm::dvec2 p) const { // by barycentric weights, which are distances over heights
        double sum = 0;
        for (std::size_t e = 0; e < 3; ++e)
            sum += distance(e, p) * length(e) / std::abs(area) * corner[(e + 2) % 3].z;
        return sum;
    }
    /// By this much it is not dropped: the shortest edge, eroded edges included, over 2 lambda. An eroded
    /// triangle is the triangle scaled about the centre of its inscribed circle.
    double excess() const {
        const double perimeter = length(0) + length(1) + length(2), radius = std::abs(area) / perimeter;
        const double shortest = std::min({length(0), length(1), length(2)});
        return shortest * std::min(1.0, 1 - lambda / radius) - 2 * lambda;
    }
};

/// > 0: covers p by this much; < 0: does not.
using Margin = std::function<double(const Seen&, std::size_t triangle, glm::dvec2 p)>;

double inside_by(const Seen& t, glm::dvec2 p, double by) {
    return std::min({t.distance(0, p), t.distance(1, p), t.distance(2, p)}) - by;
}
double in_box_by(const Seen& t, glm::dvec2 p) {
    glm::dvec2 low(t.corner[0]), high(t.corner[0]);
    for (const glm::dvec3& c : t.corner) {
        low = glm::min(low, glm::dvec2(c));
        high = glm::max(high, glm::dvec2(c));
    }
    const glm::dvec2 margin = glm::min(p - low, high - p) + lambda;
    return std::min(margin.x, margin.y);
}

struct Difference {
    std::size_t compared = 0, wrong = 0; ///< texels that a triangle covers; of all texels
    std::string first;                   ///< what the first wrong one holds
};

/// Compares every texel that no border passes within rounding.
Difference compare(const Scene& scene, const std::vector<float>& found, const Margin& margin) {
    std::vector<Seen> seen;
    for (const glm::uvec3& t : scene.triangles) seen.emplace_back(scene, t);
    // What the rasteriser's 1/256 of a texel and the corners' floats leave open.
    constexpr double open = (1 + 0.25) * 2.0 / side / 256;
    Difference difference;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::dvec2 p{(x + 0.5) * 2 / side - 1, (y + 0.5) * 2 / side - 1};
            double sure = 1, possible = 1; // nearest depths
            for (std::size_t t = 0; t < seen.size(); ++t) {
                if (seen[t].area <= 0) continue; // faces the light
                const double by = margin(seen[t], t, p);
                if (by < -open) continue;
                const double depth = std::clamp(seen[t].depth(p), 0.0, 1.0);
                possible = std::min(possible, depth);
                if (by > open) sure = std::min(sure, depth);
            }
            if (sure != possible) continue;
            if (sure < 1) ++difference.compared;
            const double got = found[static_cast<std::size_t>(y * side + x)];
            if (std::abs(got - sure) <= 1e-4)
                continue; // grown corners lie far out: their depths are summed up
            if (difference.wrong++ == 0)
                difference.first = fmt::format("texel {},{} holds {}, not {}", x, y, got, sure);
        }
    return difference;
}

void expect_drawn(const Scene& scene, const std::vector<float>& found, const Margin& margin,
                  std::size_t least) {
    const Difference difference = compare(scene, found, margin);
    EXPECT_EQ(difference.wrong, 0u) << difference.first;
    EXPECT_GT(difference.compared, least);
}

/// Triangles of all sizes and both windings, none of them a sliver.
Scene scattered(std::uint64_t seed, int triangles) {
    Scene scene;
    Random random(seed);
    const auto within = [&](double r) { return static_cast<float>(r * (2 * random.unit() - 1)); };
    while (static_cast<int>(scene.triangles.size()) < triangles) {
        const auto first = static_cast<unsigned>(scene.positions.size());
        const glm::vec3 centre{within(0.9), 0.5f + within(0.4), within(0.9)};
        const double size = 0.02 + 0.4 * random.unit();
        for (int k = 0; k < 3; ++k)
            scene.positions.push_back(centre + glm::vec3(within(size), within(0.08), within(size)));
        scene.triangles.push_back({first, first + 1, first + 2});
        const Seen seen(scene, scene.triangles.back());
        const double longest = std::max({seen.length(0), seen.length(1), seen.length(2)});
        if (std::abs(seen.area) > 0.2 * longest * longest) continue;
        scene.triangles.pop_back();
        scene.positions.resize(first);
    }
    scene.normals.resize(scene.positions.size(), glm::vec3(0, 1, 0));
    return scene;
}

TEST(PublishedMaps, GrownTrianglesReachLambdaBeyondTheirEdgesAndTheirBox) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const Scene scene = scattered(seed, 60);
        expect_drawn(
            scene, dilated(scene),
            [](const Seen& t, std::size_t, glm::dvec2 p) {
                return std::min(inside_by(t, p, -lambda), in_box_by(t, p));
            },
            2000);
    }
}

double shrunken_by(const Seen& t, glm::dvec2 p) { return t.excess() > 0 ? inside_by(t, p, lambda) : -1; }

TEST(PublishedMaps, ShrunkenTrianglesEndLambdaWithinTheirEdges) {
    for (const std::uint64_t seed : {4u, 5u, 6u}) {
        const Scene scene = scattered(seed, 60);
        for (const glm::uvec3& t : scene.triangles) ASSERT_GT(std::abs(Seen(scene, t).excess()), 1e-7);
        expect_drawn(
            scene, eroded(scene), [](const Seen& t, std::size_t, glm::dvec2 p) { return shrunken_by(t, p); },
            400);
    }
}

TEST(PublishedMaps, OfPlainTrianglesAreNeither) {
    const Scene scene = scattered(7, 60);
    const std::vector<float> map = plain(scene), big = dilated(scene), small = eroded(scene);
    std::size_t grown = 0, shrunken = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        // Every texel that a shrunken triangle covers, its triangle covers; and so on.
        EXPECT_LE(map[i] < 1, big[i] < 1) << i;
        EXPECT_LE(small[i] < 1, map[i] < 1) << i;
        grown += big[i] < 1 && !(map[i] < 1) ? 1 : 0;
        shrunken += map[i] < 1 && !(small[i] < 1) ? 1 : 0;
    }
    EXPECT_GT(grown, 200u);
    EXPECT_GT(shrunken, 200u);
}

/// Cells of two triangles, all wound to show their backs to the light, whose vertices then moved so far that
/// some turned over: lit neighbours. Windings stay consistent, as a geometry shader must assume: it sees far
/// corners, not windings.
Scene sheet(std::uint64_t seed, int cells) {
    Scene scene;
    Random random(seed);
    for (int y = 0; y <= cells; ++y)
        for (int x = 0; x <= cells; ++x) {
            const auto at = [&](int i) {
                return static_cast<float>(-0.9 + 1.8 * (i + 1.7 * (random.unit() - 0.5)) / cells);
            };
            const float across = at(x), down = at(y);
            scene.positions.push_back({across, static_cast<float>(0.4 + 0.1 * random.unit()), down});
        }
    const auto vertex = [&](int x, int y) { return static_cast<unsigned>(y * (cells + 1) + x); };
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            for (const glm::uvec3 t : {glm::uvec3(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)),
                                       glm::uvec3(vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1))}) {
                scene.triangles.push_back(t);
            }
    scene.normals.resize(scene.positions.size(), glm::vec3(0, 1, 0));
    return scene;
}

/// Per triangle, by comparing all with all: which edges have a neighbour that faces away, and which corners
/// only such ones.
struct Around {
    std::array<bool, 3> away{}, inner{true, true, true};
};
std::vector<Around> around(const Scene& scene) {
    std::vector<Around> all(scene.triangles.size());
    const auto faces_away = [&](std::size_t t) { return Seen(scene, scene.triangles[t]).area > 0; };
    for (std::size_t t = 0; t < all.size(); ++t)
        for (int e = 0; e < 3; ++e) {
            const unsigned from = scene.triangles[t][e], to = scene.triangles[t][(e + 1) % 3];
            bool border_here = false;
            for (std::size_t other = 0; other < all.size(); ++other) {
                int shared_corners = 0;
                bool at_from = false;
                for (int k = 0; k < 3; ++k) {
                    shared_corners +=
                        scene.triangles[other][k] == from || scene.triangles[other][k] == to ? 1 : 0;
                    at_from = at_from || scene.triangles[other][k] == from;
                }
                if (other != t && shared_corners == 2)
                    all[t].away[static_cast<std::size_t>(e)] = faces_away(other);
                if (at_from && !faces_away(other)) border_here = true;
            }
            // At the sheet's border: its vertices have coordinates of their own there.
            const std::size_t row = static_cast<std::size_t>(std::lround(std::sqrt(scene.positions.size())));
            const std::size_t x = from % row, y = from / row;
            if (x == 0 || y == 0 || x + 1 == row || y + 1 == row) border_here = true;
            if (border_here) all[t].inner[static_cast<std::size_t>(e)] = false;
        }
    return all;
}

/// d_i >= lambda at edges with lit neighbours, d_i + d_j >= lambda at corners that are cut.
Margin by_adjacency(const std::vector<Around>& all, bool knows_rings) {
    return [&all, knows_rings](const Seen& t, std::size_t index, glm::dvec2 p) {
        if (t.excess() <= 0) return -1.0;
        const Around& a = all[index];
        double margin = inside_by(t, p, 0);
        for (std::size_t e = 0; e < 3; ++e) {
            const std::size_t before = (e + 2) % 3;
            if (!a.away[e]) margin = std::min(margin, t.distance(e, p) - lambda);
            if (a.away[e] && a.away[before] && !(knows_rings && a.inner[e]))
                margin = std::min(margin, t.distance(e, p) + t.distance(before, p) - lambda);
        }
        return margin;
    };
}

TEST(PublishedMaps, AdjacencyMovesEdgesTowardsLitNeighboursAlone) {
    if (!shared_device().has_geometry_shaders())
        GTEST_SKIP() << "this device has no geometry shaders: crsma refuses";
    for (const std::uint64_t seed : {8u, 9u}) {
        const Scene scene = sheet(seed, 9);
        const std::vector<Around> all = around(scene);
        expect_drawn(scene, adjacent(scene), by_adjacency(all, false), 2000);
    }
}

TEST(PublishedMaps, RingsCutOnlyCornersThatALitFaceTouches) {
    for (const std::uint64_t seed : {8u, 9u}) {
        const Scene scene = sheet(seed, 9);
        const std::vector<Around> all = around(scene);
        expect_drawn(scene, one_ring(scene), by_adjacency(all, true), 2000);
    }
}

/// The comparison must see maps of another kind, and NaN.
TEST(PublishedMaps, AreToldApart) {
    if (!shared_device().has_geometry_shaders())
        GTEST_SKIP() << "this device has no geometry shaders: crsma refuses";
    const Scene scene = scattered(7, 60);
    const auto grown = [](const Seen& t, std::size_t, glm::dvec2 p) {
        return std::min(inside_by(t, p, -lambda), in_box_by(t, p));
    };
    const auto shrunken = [](const Seen& t, std::size_t, glm::dvec2 p) { return shrunken_by(t, p); };
    EXPECT_GT(compare(scene, plain(scene), grown).wrong, 200u);
    EXPECT_GT(compare(scene, plain(scene), shrunken).wrong, 200u);
    std::vector<float> broken = dilated(scene);
    for (float& depth : broken) depth = depth < 1 ? std::numeric_limits<float>::quiet_NaN() : depth;
    EXPECT_GT(compare(scene, broken, grown).wrong, 2000u);

    const Scene folded = sheet(8, 9);
    const std::vector<Around> all = around(folded);
    EXPECT_GT(compare(folded, eroded(folded), by_adjacency(all, false)).wrong, 500u);
    EXPECT_GT(compare(folded, adjacent(folded), by_adjacency(all, true)).wrong, 8u);
    EXPECT_GT(compare(folded, one_ring(folded), by_adjacency(all, false)).wrong, 8u);
    const auto lit = [&](const glm::uvec3& t) { return Seen(folded, t).area < 0; };
    EXPECT_GT(std::ranges::count_if(folded.triangles, lit), 5);
}

TEST(PublishedMaps, EachKnowsMoreThanTheLast) {
    if (!shared_device().has_geometry_shaders())
        GTEST_SKIP() << "this device has no geometry shaders: crsma refuses";
    const Scene scene = sheet(10, 9);
    const auto count = [](const std::vector<float>& map) {
        return std::ranges::count_if(map, [](float depth) { return depth < 1; });
    };
    const std::vector<float> small = eroded(scene), by_edges = adjacent(scene), by_rings = one_ring(scene);
    for (std::size_t i = 0; i < small.size(); ++i) {
        EXPECT_LE(small[i] < 1, by_edges[i] < 1) << i;
        EXPECT_LE(by_edges[i] < 1, by_rings[i] < 1) << i;
    }
    EXPECT_LT(count(small) + 500, count(by_edges));
    EXPECT_LT(count(by_edges) + 20, count(by_rings));
}

} // namespace
} // namespace gnomon::testing
