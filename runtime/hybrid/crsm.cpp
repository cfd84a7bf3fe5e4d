// Two conservative maps: of grown triangles, which no light passes by, and of shrunken ones, through which
// none passes. [Hertel, Hormann and Westermann 2009; thesis ch. 3.4.2 and 4]
#include "runtime/error.h"
#include "runtime/hybrid/depth_pass.h"
#include "runtime/hybrid/make.h"

namespace gnomon {
namespace {

/// The second map and what it draws. The first is the same for all three techniques.
struct SmallMap {
    DepthStages stages;
    gpu::Topology topology = gpu::Topology::triangles;
    std::vector<std::uint32_t> indices; ///< empty: the scene's triangles
};

class Crsm : public Classifier {
public:
    Crsm(Resources& resources, const SmallMap& small)
        : resources_(resources),
          big_(resources, {"hybrid/dilated.vert", "", "hybrid/dilated.frag"}, gpu::Cull::front),
          small_(resources, small.stages, gpu::Cull::front, small.topology),
          kernel_(resources.kernel("hybrid/detect_crsm.comp")) {
        if (resources.frame.light_origin.w == 1.0f)
            throw Error("conservative shadow maps are for directional lights: leave out --light-position");
        if (!small.indices.empty()) {
            indices_ = resources.device.upload(small.indices);
            small_vertices_ = static_cast<std::uint32_t>(small.indices.size());
        }
    }

    void create_maps() override {
        Resources& r = resources_;
        big_.draw({&r.frame_buffer, &r.positions, &r.triangles}, r.vertices);
        if (small_vertices_ > 0)
            small_.draw({&r.frame_buffer, &r.positions, &indices_}, small_vertices_);
        else
            small_.draw({&r.frame_buffer, &r.positions, &r.triangles}, r.vertices);
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
    gpu::Buffer indices_;
    std::uint32_t small_vertices_ = 0; ///< 0: those of the scene's triangles
};

} // namespace

std::unique_ptr<Classifier> make_crsm(Resources& resources) {
    return std::make_unique<Crsm>(resources, SmallMap{{"hybrid/eroded.vert", "", ""}});
}

} // namespace gnomon
