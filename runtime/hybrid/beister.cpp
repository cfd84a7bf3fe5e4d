// One shadow map; certain where the taps around a receiver agree.   [Beister, Ernst and Stamminger 2005]
#include "runtime/hybrid/depth_pass.h"
#include "runtime/hybrid/make.h"

#include <fmt/format.h>

namespace gnomon {
namespace {

class Taps : public Classifier {
public:
    /// `kernel` is below kernels/certainty.
    Taps(Resources& resources, const char* kernel)
        : resources_(resources),
          map_(resources,
               {"shadow_map.vert", "", resources.frame.light_origin.w == 1.0f ? "shadow_map.frag" : ""},
               static_cast<gpu::Cull>(resources.frame.rules.y)) {
        glsl::Sources sources = resources.sources;
        sources.generated["certainty"] = fmt::format("#include \"certainty/{0}.glsl\"\n"
                                                     "uint certainty_of_taps(ivec2 texel, vec2 p) {{\n"
                                                     "    return certainty_{0}(texel, p);\n}}\n",
                                                     kernel);
        kernel_ = resources.device.kernel(resources.stage("hybrid/detect_beister.comp", sources), kernel);
    }

    void create_maps() override {
        Resources& r = resources_;
        map_.draw({&r.frame_buffer, &r.positions, &r.triangles}, r.vertices);
    }

    void detect(gpu::Buffer& states) override {
        Resources& r = resources_;
        r.device.run(kernel_, {&r.frame_buffer, &r.receivers, &map_.texels(), &states, &r.visibility},
                     r.per_pixel());
    }

    MapCost cost() const override { return {resources_.vertices / 3, sizeof(float)}; }

private:
    Resources& resources_;
    DepthPass map_;
    gpu::Kernel kernel_;
};

} // namespace

std::unique_ptr<Classifier> make_beister(Resources& resources) {
    return std::make_unique<Taps>(resources, "beister");
}
std::unique_ptr<Classifier> make_bilinear(Resources& resources) {
    return std::make_unique<Taps>(resources, "bilinear");
}

} // namespace gnomon
