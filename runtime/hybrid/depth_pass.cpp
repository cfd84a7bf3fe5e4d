#include "runtime/hybrid/depth_pass.h"

namespace gnomon {

DepthPass::DepthPass(Resources& resources, const DepthStages& stages, gpu::Cull cull, gpu::Topology topology)
    : resources_(resources) {
    const auto compiled = [&](const std::string& file) {
        return file.empty() ? glsl::Spirv{} : resources.stage(file);
    };
    const bool directional = resources.frame.light_origin.w == 0.0f;
    raster_ = resources.device.raster(
        compiled(stages.vertex), compiled(stages.fragment),
        {.colours = {}, .clamp_depth = directional, .cull = cull, .topology = topology}, stages.vertex,
        compiled(stages.geometry));
    const std::uint32_t side = resources.frame.size.z;
    target_ = resources.device.target(side, side, gpu::Format::depth32_float);
}

const gpu::Buffer& DepthPass::draw(std::initializer_list<const gpu::Buffer*> buffers,
                                   std::uint32_t vertices) {
    resources_.device.draw(raster_, {}, target_, buffers, vertices);
    texels_ = resources_.device.texels(target_);
    return texels_;
}

} // namespace gnomon
