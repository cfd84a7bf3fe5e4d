// Two conservative maps: of grown triangles, which no light passes by, and of shrunken ones, through which
// none passes. [Hertel, Hormann and Westermann 2009; thesis ch. 3.4.2 and 4]
#include "runtime/adjacency.h"
#include "runtime/error.h"
#include "runtime/hybrid/depth_pass.h"
#include "runtime/hybrid/make.h"

namespace gnomon {
namespace {

/// The second map. The first is the same for all three techniques.
struct SmallMap {
    DepthStages stages;
    gpu::Topology topology = gpu::Topology::triangles;
    std::vector<std::uint32_t> indices{};    ///< bound instead of the scene's triangles; empty: these
    std::vector<std::uint32_t> neighbours{}; ///< bound behind them, one a triangle; empty: not bound
    std::uint32_t vertices = 0;
};

class Crsm : public Classifier {
public:
    Crsm(Resources& resources, const SmallMap& small)
        : resources_(resources),
          big_(resources, {"hybrid/dilated.vert", "", "hybrid/dilated.frag"}, gpu::Cull::front),
          small_(resources, small.stages, gpu::Cull::front, small.topology),
          kernel_(resources.kernel("hybrid/detect_crsm.comp")), small_vertices_(small.vertices) {
        if (resources.frame.light_origin.w == 1.0f)
            throw Error("conservative shadow maps are for directional lights: leave out --light-position");
        if (!small.indices.empty()) indices_ = resources.device.upload(small.indices);
        if (!small.neighbours.empty()) neighbours_ = resources.device.upload(small.neighbours);
        has_indices_ = !small.indices.empty();
        has_neighbours_ = !small.neighbours.empty();
    }

    void create_maps() override {
        Resources& r = resources_;
        big_.draw({&r.frame_buffer, &r.positions, &r.triangles}, r.vertices);
        const gpu::Buffer* indices = has_indices_ ? &indices_ : &r.triangles;
        if (has_neighbours_)
            small_.draw({&r.frame_buffer, &r.positions, indices, &neighbours_}, small_vertices_);
        else
            small_.draw({&r.frame_buffer, &r.positions, indices}, small_vertices_);
    }

    void detect(gpu::Buffer& states) override {
        Resources& r = resources_;
        r.device.run(
            kernel_,
            {&r.frame_buffer, &r.receivers, &big_.texels(), &small_.texels(), &states, &r.visibility},
            r.per_pixel());
    }

private:
    Resources& resources_;
    DepthPass big_, small_;
    gpu::Kernel kernel_;
    gpu::Buffer indices_, neighbours_;
    bool has_indices_ = false, has_neighbours_ = false;
    std::uint32_t small_vertices_;
};

/// Six indices a triangle: its corners, and behind each the far corner of the triangle beyond the edge that
/// begins there; without one the corner itself again. Where more than two triangles meet at an edge it is the
/// next by number: the thesis does not say, and its counts are met by any.   [thesis ch. 4; hybrid.md,
/// convention 10]
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

/// As kernels/hybrid/one_ring.vert reads them.
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

} // namespace

std::unique_ptr<Classifier> make_crsm(Resources& r) {
    return std::make_unique<Crsm>(r,
                                  SmallMap{.stages = {"hybrid/eroded.vert", "", ""}, .vertices = r.vertices});
}

std::unique_ptr<Classifier> make_crsma(Resources& r) {
    return std::make_unique<Crsm>(r,
                                  SmallMap{.stages = {"hybrid/adjacency.vert", "hybrid/adjacency.geom", ""},
                                           .topology = gpu::Topology::triangles_with_adjacency,
                                           .indices = with_far_corners(r.scene),
                                           .vertices = 2 * r.vertices});
}

std::unique_ptr<Classifier> make_crsma_one_ring(Resources& r) {
    return std::make_unique<Crsm>(r,
                                  SmallMap{.stages = {"hybrid/one_ring.vert", "", ""},
                                           .neighbours = ring_bits(r.scene, glm::vec3(r.frame.light_origin)),
                                           .vertices = 4 * r.vertices});
}

} // namespace gnomon
