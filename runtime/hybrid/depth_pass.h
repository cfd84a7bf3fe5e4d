// One raster pass from the light: a depth map as large as the frame's shadow map.
#pragma once

#include "runtime/pipeline/resources.h"

#include <initializer_list>
#include <string>

namespace gnomon {

/// Its stages' files below the kernels' folder; an empty one is left out.
struct DepthStages {
    std::string vertex, geometry, fragment;
};

class DepthPass {
public:
    /// `resources` must outlive it. Depth beyond near and far is clamped, as a directional light needs; a
    /// perspective light's stages write depth themselves. Throws Error if the device lacks a stage.
    DepthPass(Resources& resources, const DepthStages& stages, gpu::Cull cull,
              gpu::Topology topology = gpu::Topology::triangles);

    /// Nearest depths in row order, 1 where there is nothing, until the next draw.
    const gpu::Buffer& draw(std::initializer_list<const gpu::Buffer*> buffers, std::uint32_t vertices);
    const gpu::Buffer& texels() const { return texels_; }

private:
    Resources& resources_;
    gpu::Raster raster_;
    gpu::Target target_;
    gpu::Buffer texels_;
};

} // namespace gnomon
