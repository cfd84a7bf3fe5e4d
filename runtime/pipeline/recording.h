// Calls of kernels as a frame's stages make them: the kernels' files are replaced by texts that also record
// (kernels/pipeline/record.glslh), and whatever stage includes one of them writes what it called.
#pragma once

#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

/// A stage as it was compiled.
struct StageText {
    std::string file; ///< below the kernels' folder: "hybrid/detect_lists.comp"
    std::string text; ///< with everything that it includes
};

/// What stages are compiled with while their calls are to be recorded.
struct Recording {
    std::map<std::string, std::string> overlaid; ///< texts that stand for kernels' files (glsl::Sources)
    std::vector<StageText> stages{};             ///< compiled so far
};

/// Whether the stage's invocations are the image's pixels: the detectors', which say what maps are certain
/// of.
bool is_of_pixels(const std::string& stage_file);

/// Compiles a stage with the recording's texts, and adds it to the recording's stages. Throws as
/// glsl::compile.
glsl::Spirv compile_recording(Recording& recording, const std::string& file, const glsl::Sources& sources,
                              glsl::Stage kind);

/// One call. Ordered as its members are: by stage, then row by row.
struct RecordedCall {
    std::uint32_t stage; ///< of Recording::stages
    /// The invocation: of a compute stage its number along x and y, else along x alone the vertex, or the
    /// primitive of a geometry shader; of a fragment shader the texel.
    std::uint32_t y, x;
    std::uint32_t number;             ///< among the calls of its invocation, which all recorded kernels share
    std::uint32_t tag;                ///< the text's
    std::vector<std::uint32_t> words; ///< what the text recorded
    friend auto operator<=>(const RecordedCall&, const RecordedCall&) = default;
};

/// Runs `frame`, which starts stages of the recording, until there is room for all that they record. Of a
/// `width` by `height` image only the stages of pixels are recorded, and of these pixels; or, if there are
/// none, all stages. Throws Error if that is more than 2^28 words or than a buffer of the device holds, or if
/// a stage that draws records and the device cannot.
std::vector<RecordedCall> record_calls(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                                       std::span<const std::uint32_t> pixels,
                                       const std::function<void()>& frame);

/// The calls that such words hold (kernels/pipeline/record.glslh), sorted, each once: the device may run a
/// vertex more often, and fragments of several triangles in one texel may call alike.
std::vector<RecordedCall> read_calls(std::span<const std::uint32_t> words);

} // namespace gnomon
