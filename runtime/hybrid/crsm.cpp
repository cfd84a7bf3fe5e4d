// Two conservative maps: of grown triangles, which no light passes by, and of shrunken ones, through which
// none passes. [Hertel, Hormann and Westermann 2009; thesis ch. 3.4.2 and 4]
#include "runtime/error.h"
#include "runtime/hybrid/adjacent.h"
#include "runtime/hybrid/depth_pass.h"
#include "runtime/hybrid/make.h"

#include <utility>

namespace gnomon {
namespace {

/// The second map. The first is the same for all three techniques.
struct SmallMap {
    DepthStages stages;
    gpu::Topology topology = gpu::Topology::triangles;
    std::vector<std::uint32_t> indices{};    ///< bound instead of the scene's triangles; empty: these
    std::vector<std::uint32_t> neighbours{}; ///< bound behind them, one a triangle; empty: not bound
    std::uint32_t vertices = 0;
    std::size_t emitted = 0; ///< triangles
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
        cost_ = {resources.vertices / 3 + small.emitted, 2 * sizeof(float)};
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

    MapCost cost() const override { return cost_; }

private:
    Resources& resources_;
    DepthPass big_, small_;
    gpu::Kernel kernel_;
    gpu::Buffer indices_, neighbours_;
    bool has_indices_ = false, has_neighbours_ = false;
    std::uint32_t small_vertices_;
    MapCost cost_;
};

/// Triangles that hybrid/adjacency.geom emits in the resources' frame.
std::size_t count_adjacent(Resources& r, const std::vector<std::uint32_t>& indices) {
    gpu::Kernel kernel = r.kernel("hybrid/count_adjacent.comp");
    const gpu::Buffer six = r.device.upload(indices);
    const gpu::Buffer total = r.device.upload(std::vector<std::uint32_t>{0});
    r.device.run(kernel, {&r.frame_buffer, &r.positions, &six, &total}, {.threads = {r.vertices / 3, 1, 1}});
    return r.device.read<std::uint32_t>(total).front();
}

} // namespace

std::unique_ptr<Classifier> make_crsm(Resources& r) {
    return std::make_unique<Crsm>(r, SmallMap{.stages = {"hybrid/eroded.vert", "", ""},
                                              .vertices = r.vertices,
                                              .emitted = r.vertices / 3});
}

std::unique_ptr<Classifier> make_crsma(Resources& r) {
    std::vector<std::uint32_t> indices = with_far_corners(r.scene);
    const std::size_t emitted = count_adjacent(r, indices);
    return std::make_unique<Crsm>(r,
                                  SmallMap{.stages = {"hybrid/adjacency.vert", "hybrid/adjacency.geom", ""},
                                           .topology = gpu::Topology::triangles_with_adjacency,
                                           .indices = std::move(indices),
                                           .vertices = 2 * r.vertices,
                                           .emitted = emitted});
}

std::unique_ptr<Classifier> make_crsma_one_ring(Resources& r) {
    return std::make_unique<Crsm>(r,
                                  SmallMap{.stages = {"hybrid/one_ring.vert", "", ""},
                                           .neighbours = ring_bits(r.scene, glm::vec3(r.frame.light_origin)),
                                           .vertices = 4 * r.vertices,
                                           .emitted = std::size_t{4} * (r.vertices / 3)});
}

} // namespace gnomon
