// What the steps of a frame share on the device: the renderer makes it, every technique's steps read it.
#pragma once

#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"
#include "runtime/pipeline/frame.h"
#include "runtime/pipeline/technique.h"
#include "runtime/scene.h"

namespace gnomon {

struct Resources {
    gpu::Device& device;
    glsl::Sources sources;
    const Scene& scene;
    shared::Frame frame;
    std::uint32_t vertices; ///< three per triangle

    gpu::Buffer frame_buffer, positions, normals, triangles;
    gpu::Buffer world_texels, normal_texels; ///< the G-buffer: position and triangle + 1; shading normal
    gpu::Buffer receivers;                   ///< kernels/pipeline/receiver.glslh, per pixel
    gpu::Buffer visibility;                  ///< float per pixel: what every technique writes

    /// A stage by its file below the kernels' folder ("hybrid/fill.comp"), or below pipeline/.
    glsl::Spirv stage(const std::string& file) const { return stage(file, sources); }
    static glsl::Spirv stage(const std::string& file, const glsl::Sources& from) {
        const glsl::Stage kind = file.ends_with(".vert")   ? glsl::Stage::vertex
                                 : file.ends_with(".frag") ? glsl::Stage::fragment
                                 : file.ends_with(".geom") ? glsl::Stage::geometry
                                                           : glsl::Stage::compute;
        return glsl::compile(from, stage_text(from, file), stage_name(from, file), kind);
    }
    gpu::Kernel kernel(const std::string& file) const { return device.kernel(stage(file), file); }

    std::size_t pixels() const { return std::size_t{frame.size.x} * frame.size.y; }
    gpu::Dispatch per_pixel() const { return {.threads = {frame.size.x, frame.size.y, 1}}; }
};

} // namespace gnomon
