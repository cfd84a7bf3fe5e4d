#include "runtime/pipeline/recording.h"

#include "runtime/error.h"
#include "runtime/pipeline/technique.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace gnomon {
namespace {

constexpr std::uint32_t binding = 31; // of kernels/pipeline/record.glslh
constexpr std::size_t header = 4, call_header = 6;

/// <record/stage>
std::string invocation_text(std::size_t number, const std::string& file, glsl::Stage kind) {
    const char* invocation = kind == glsl::Stage::compute    ? "gl_GlobalInvocationID.xy"
                             : kind == glsl::Stage::vertex   ? "uvec2(gl_VertexIndex, 0)"
                             : kind == glsl::Stage::geometry ? "uvec2(gl_PrimitiveIDIn, 0)"
                                                             : "uvec2(gl_FragCoord.xy)";
    return fmt::format("const uint RECORD_STAGE = {}u;\nconst bool RECORD_PIXELS = {};\n"
                       "uvec2 record_invocation() {{ return {}; }}\n",
                       number, is_of_pixels(file), invocation);
}

/// The buffer's first words, behind which there is room for `room` more.
std::vector<std::uint32_t> record_words(std::uint32_t width, std::uint32_t height,
                                        std::span<const std::uint32_t> pixels, std::size_t room) {
    std::vector<std::uint32_t> words(header);
    if (!pixels.empty()) {
        words[2] = width;
        words[3] = (width * height + 31) / 32;
        words.resize(header + words[3]);
        for (const std::uint32_t pixel : pixels) {
            if (pixel >= width * height) throw std::out_of_range("a pixel outside the image");
            words[header + pixel / 32] |= 1u << (pixel % 32);
        }
    }
    words.resize(words.size() + std::max<std::size_t>(room, 1));
    return words;
}

/// Binds the buffer where stages record, as long as it is there.
class Bound {
public:
    Bound(gpu::Device& device, const gpu::Buffer& buffer) : device_(device) {
        device_.bind_always(binding, &buffer);
    }
    Bound(const Bound&) = delete;
    Bound& operator=(const Bound&) = delete;
    ~Bound() { device_.bind_always(binding, nullptr); }

private:
    gpu::Device& device_;
};

} // namespace

bool is_of_pixels(const std::string& stage_file) { return stage_file.starts_with("hybrid/detect_"); }

glsl::Spirv compile_recording(Recording& recording, const std::string& file, const glsl::Sources& sources,
                              glsl::Stage kind) {
    glsl::Sources with = sources;
    for (const auto& [name, text] : recording.overlaid) with.overlaid[name] = text;
    with.generated["record/stage"] = invocation_text(recording.stages.size(), file, kind);
    const std::string name = stage_name(with, file);
    recording.stages.push_back({file, glsl::expand(with, stage_text(with, file), name)});
    return glsl::compile_expanded(recording.stages.back().text, name, kind);
}

std::vector<RecordedCall> read_calls(std::span<const std::uint32_t> words) {
    std::vector<RecordedCall> calls;
    for (std::size_t at = 0; at < words.size();) {
        const std::span<const std::uint32_t> call = words.subspan(at, call_header + words[at + 5]);
        const auto payload = call.subspan(call_header);
        calls.push_back({call[0], call[1], call[2], call[3], call[4], {payload.begin(), payload.end()}});
        at += call.size();
    }
    std::ranges::sort(calls);
    calls.erase(std::unique(calls.begin(), calls.end()), calls.end());
    return calls;
}

std::vector<RecordedCall> record_calls(gpu::Device& device, std::uint32_t width, std::uint32_t height,
                                       std::span<const std::uint32_t> pixels,
                                       const std::function<void()>& frame) {
    const std::size_t marks = record_words(width, height, pixels, 0).size();
    const std::size_t most =
        std::min(std::size_t{1} << 28, device.max_buffer() / sizeof(std::uint32_t)) - marks;
    for (std::size_t room = 0;;) {
        const gpu::Buffer buffer = device.upload(record_words(width, height, pixels, room));
        const Bound bound(device, buffer);
        frame();
        const std::vector<std::uint32_t> words = device.read<std::uint32_t>(buffer);
        const std::size_t needed = words[0], begin = header + words[3];
        if (words[1] != 0 || needed > most)
            throw Error("all these calls are more than the {} words that can be recorded; take fewer pixels, "
                        "or a smaller image or shadow map",
                        most);
        if (needed <= room) return read_calls(std::span(words).subspan(begin, needed));
        room = std::min(needed + needed / 8, most); // the order of lists decides who is looked at
    }
}

} // namespace gnomon
