// What the steps of a frame share on the device: the renderer makes it, every technique's steps read it.
#pragma once

#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"
#include "runtime/pipeline/frame.h"
#include "runtime/pipeline/recording.h"
#include "runtime/pipeline/technique.h"
#include "runtime/scene.h"

#include <algorithm>
#include <optional>

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
    Recording* recording = nullptr;          ///< what stages are compiled with; null: with nothing else
    std::optional<Box> seen{}; ///< of this frame's shadow rays' origins, if it was needed already (seen.h)

    /// A stage by its file below the kernels' folder ("hybrid/fill.comp"), or below pipeline/.
    glsl::Spirv stage(const std::string& file) const { return stage(file, sources); }
    glsl::Spirv stage(const std::string& file, const glsl::Sources& from) const {
        const glsl::Stage kind = file.ends_with(".vert")   ? glsl::Stage::vertex
                                 : file.ends_with(".frag") ? glsl::Stage::fragment
                                 : file.ends_with(".geom") ? glsl::Stage::geometry
                                                           : glsl::Stage::compute;
        if (recording != nullptr) return compile_recording(*recording, file, from, kind);
        return glsl::compile(from, stage_text(from, file), stage_name(from, file), kind);
    }
    gpu::Kernel kernel(const std::string& file) const { return device.kernel(stage(file), file); }

    std::size_t pixels() const { return std::size_t{frame.size.x} * frame.size.y; }
    /// `n` invocations in as many rows of workgroups as the device needs (kernels/pipeline/linear.glslh).
    static gpu::Dispatch linear(std::size_t n) {
        constexpr std::size_t row = std::size_t{1} << 21; // 32,768 workgroups of 64
        const auto rows = static_cast<std::uint32_t>((n + row - 1) / row);
        return {.threads = {static_cast<std::uint32_t>(std::min(n, row)), std::max(rows, 1u), 1}};
    }
    /// Tiles of 16 x 16 pixels: kernels/hybrid/tile.glslh.
    std::uint32_t tiles() const { return ((frame.size.x + 15) / 16) * ((frame.size.y + 15) / 16); }
    gpu::Dispatch per_pixel() const { return {.threads = {frame.size.x, frame.size.y, 1}}; }
};

} // namespace gnomon
