// Kernel inputs as a frame meets them. One kernel's file is replaced by a text that also records what it is
// called with and what it answers, so that both are computed by the kernels' own text on the device; then the
// same calls can be made alone, and must give the same bits.
#pragma once

#include "casegen/catalogue.h"
#include "runtime/pipeline/renderer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// The kernel's text, and a function of its name that records under `tag` its parameters' words and its
/// result's (kernels/pipeline/record.glslh), in this order and after the call: calls that it makes come
/// before it. `text` is what the kernel's file says.
std::string recording_text(const Case& c, std::string_view text, unsigned tag);

/// A kernel that the pipeline calls where it asks a technique one of two questions.
struct ChainLink {
    const Case* kernel;
    Question question;
};

/// The kernels of the catalogue that a technique of kind `kernel` can call at a pixel, in the catalogue's
/// order: those of its visibility, and those that only its number needs.
std::vector<ChainLink> chain_of(const glsl::Sources& sources, const Technique& technique);

/// The kernels of the catalogue that a hybrid's stages can call, in the catalogue's order.
std::vector<const Case*> kernels_of(const std::vector<StageText>& stages);

/// The pixels that a technique's kernels are asked about: those that face the light, within its map.
std::vector<std::uint32_t> asked_pixels(Renderer& renderer);

/// The number of the case that each of these pixels is of, 0 for none. The technique's family must have a
/// kernel `number`.
std::vector<std::uint32_t> case_numbers(Renderer& renderer, const Technique& technique,
                                        const std::vector<std::uint32_t>& pixels);

/// Those of these pixels at which the technique calls the kernel.
std::vector<std::uint32_t> calling_pixels(Renderer& renderer, const glsl::Sources& sources,
                                          const Technique& technique, const ChainLink& link,
                                          const std::vector<std::uint32_t>& pixels);

struct CapturedCall {
    std::optional<std::uint32_t> pixel; ///< none where a stage works on triangles or texels of a map
    std::vector<std::uint32_t> inputs;  ///< the parameters' words; a texel is counted in `window`
    std::vector<std::uint32_t> result;  ///< what the kernel answered in the pipeline
    float visibility = 0;               ///< of the whole technique at the pixel, in a frame without recording
    std::shared_ptr<const Mask> window; ///< null if the kernel takes no mask
    std::uint32_t stage = 0;            ///< of Captured::stages
    glm::uvec2 invocation{0};           ///< of the stage (RecordedCall)
};

struct Captured {
    const Case* kernel = nullptr;
    std::vector<CapturedCall> calls{}; ///< in the order of the pixels asked for and of each one's calls
    /// Pixels whose visibility was another while calls were recorded: a kernel is then no function of its
    /// parameters.
    std::vector<std::uint32_t> unlike_frame{};
    std::vector<std::string> stages{}; ///< of a hybrid: its stages' files
    std::size_t all = 0;               ///< of a hybrid: calls that were made, each once
};

/// All calls of these kernels at these pixels, by kernel. chain_of must say that the technique calls each
/// where it is asked this question, asked_pixels must hold each pixel. `sources` are the renderer's. Throws
/// Error if a kernel looks at the map from another texel than the pixel's own: the window that is captured is
/// centred there.
std::vector<Captured> capture_calls(Renderer& renderer, const glsl::Sources& sources,
                                    const Technique& technique, Question question,
                                    const std::vector<const Case*>& kernels,
                                    const std::vector<std::uint32_t>& pixels);

/// Calls of these kernels in a frame of a hybrid, by kernel; each one's by stage and row by row: of these
/// pixels, or, if there are none, of all stages; at most `most` (0: all). Throws Error as
/// Renderer::record_frame.
std::vector<Captured> capture_frame_calls(Renderer& renderer, const glsl::Sources& sources,
                                          const Technique& technique, const std::vector<const Case*>& kernels,
                                          const std::vector<std::uint32_t>& pixels, std::size_t most = 0);

/// At most `most` (0: all) of them, evenly spread.
template <typename T>
std::vector<T> spread(std::vector<T> all, std::size_t most) {
    if (most == 0 || all.size() <= most) return all;
    std::vector<T> kept;
    for (std::size_t i = 0; i < most; ++i) kept.push_back(std::move(all[i * all.size() / most]));
    return kept;
}

/// A file that read_inputs reads: the kernel's columns, then `pixel_x`, `pixel_y` and `visibility`, empty
/// where a call is no pixel's, with the answer between them as `captured` (`captured_x`, … of a vector); of a
/// hybrid also `stage`, `invocation_x` and `invocation_y`. `width` is the image's; `comment` goes above, its
/// lines after "# ".
std::string captured_csv(const Captured& captured, int width, const std::string& comment);

/// "result", or "result_x", "result_y" …: the columns of a kernel's result under this name.
std::vector<std::string> result_columns(const Case& c, const std::string& name);

/// Rows (from 0) of inputs whose result alone is not the wanted one, bit for bit; every NaN is alike.
/// `wanted` and `got` hold the result's components, row by row.
std::vector<std::size_t> differing_rows(const Case& c, std::span<const std::uint32_t> wanted,
                                        std::span<const std::uint32_t> got);

} // namespace gnomon
