// A frame, step by step: G-buffer, receivers, shadow map, a technique's visibility, shading; and the
// ray-traced truth. Everything but visibility is the same for every technique.
#pragma once

#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"
#include "runtime/hybrid/choice.h"
#include "runtime/hybrid/hybrid.h"
#include "runtime/image.h"
#include "runtime/pipeline/recording.h"
#include "runtime/pipeline/stopwatch.h"
#include "runtime/pipeline/technique.h"
#include "runtime/pipeline/view.h"
#include "runtime/rays.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

struct Rendering {
    std::vector<float> visibility; ///< per pixel, row-major; 0 where the surface faces away or there is none
    Image image;
    std::vector<Step> steps;
    /// Pixels whose case the technique's assembly did not hold, in one frame; if any, `visibility` was found
    /// again with all cases, in a step of its own.
    std::size_t left_out = 0;
    std::optional<HybridFrame> hybrid; ///< of the last frame of a hybrid technique
    std::optional<Choice> choice;      ///< what an automatic technique chose, and from which times
};

/// One technique's frames without what all techniques share: no G-buffer, no shading.
struct TechniqueTimes {
    std::vector<Step> steps;       ///< medians, in the order of the steps
    double milliseconds = 0;       ///< of whole frames: a median of its own
    double least = 0, most = 0;    ///< of the same frames
    std::vector<double> rounds;    ///< the same frames, one by one, in milliseconds
    std::vector<float> visibility; ///< as Rendering's
    HybridFrame frame;             ///< the last; nothing of a technique that is no hybrid
};

/// What is the same for all techniques, per pixel.
struct Surfaces {
    std::vector<std::uint8_t> covered; ///< 1 where the camera sees a surface
    std::vector<std::uint8_t> facing;  ///< 1 where that surface faces the light
};

/// What one pixel's kernel saw: enough to run it again alone.
struct Capture {
    static constexpr int radius = 18; ///< texels around its own that any walk can reach
    glm::ivec2 texel{0};
    glm::vec2 p{0};
    std::vector<std::uint8_t> lit; ///< (2 radius + 1)² texels, row-major, centred on `texel`
};

/// Kernels' calls in a frame, and what it was like meanwhile.
struct Recorded {
    std::vector<RecordedCall> calls;
    /// What the technique answered at each pixel, as bits: of those asked about, or of all of a hybrid's.
    std::vector<std::uint32_t> answers;
    std::vector<StageText> stages;
};

class Renderer {
public:
    /// Uploads the scene and compiles the stages that all techniques share. `device` and `scene` must outlive
    /// it. Throws Error (see require_valid; too many triangles for a float to count: 2^24).
    Renderer(gpu::Device& device, glsl::Sources sources, const Scene& scene, const Camera& camera,
             const Light& light, const ViewSettings& settings);
    ~Renderer();

    /// From another camera, in another light of the same kind, with the settings that it has. Throws Error as
    /// the constructor does; then nothing has changed.
    void look(const Camera& camera, const Light& light);

    const ViewSettings& settings() const; ///< the constructor's; look keeps them

    /// Renders `frames` + 1 times (at least 2) and keeps the medians of the last `frames`.
    Rendering render(const Technique& technique, int frames = 5);

    /// The same visibility, of one frame that is not shaded.
    std::vector<float> visibility(const Technique& technique);

    /// Pixels that the technique's kernels are asked about, by the number of their case: as many numbers as
    /// census_size. 0 is no case. The technique's family must have a kernel `number`.
    std::vector<std::uint64_t> census(const Technique& technique);
    static constexpr std::size_t census_size = 256;

    /// Milliseconds on the device of each technique's visibility kernel, over the same receivers and map: the
    /// techniques take turns, so that a machine that slows down slows all of them alike. Medians of `rounds`;
    /// one more is discarded. Nothing falls back.
    std::vector<double> time_visibility(const std::vector<Technique>& techniques, int rounds);

    /// Techniques of any kind over one G-buffer, in turns as above: frames on the wall, from maps to the last
    /// pixel's visibility. The first round, which compiles and builds the BVH, is discarded; `rounds` more
    /// count.
    std::vector<TechniqueTimes> time_techniques(const std::vector<Technique>& techniques, int rounds);

    /// What an automatic technique takes in this view: calibrated when it is first asked for, and then kept
    /// until look. Sizes, scene and device are a renderer's for ever. What the losers held on the device is
    /// released.
    const Choice& choice(bool prune = true);

    /// Milliseconds from the technique's SPIR-V to the end of its first dispatch, less those of a second one:
    /// what the driver takes to compile it, unless it has seen it before.
    double time_first_visibility(const Technique& technique);

    /// What the last frame of this hybrid technique knew of each pixel, row-major. Renders one if there was
    /// none.
    std::vector<PixelState> states(const Technique& technique);

    const Surfaces& surfaces();

    /// Depth along the light's axis per texel, row-major: 0 at near, 1 at far and where there is nothing.
    std::vector<float> shadow_map();

    /// What every pixel asks of the shadow map (kernels/pipeline/receiver.glslh).
    const std::vector<shared::Receiver>& receivers();

    /// The pixels' inputs to a technique's kernel. Only pixels inside the map that face the light have any.
    std::vector<Capture> capture(const std::vector<std::uint32_t>& pixels);

    /// Asks a technique of kind `kernel` at these pixels, of which the same is true; a call's x is the
    /// number of its pixel among them. `overlaid` are texts that stand for kernels' files (Recording).
    /// Throws Error as record_calls.
    Recorded record(const Technique& technique, Question question, const std::vector<std::uint32_t>& pixels,
                    const std::map<std::string, std::string>& overlaid);

    /// A frame of a hybrid technique, whose stages record: at these pixels, or, if there are none, everywhere
    /// and in all stages (record_calls).
    Recorded record_frame(const Technique& technique, const std::vector<std::uint32_t>& pixels,
                          const std::map<std::string, std::string>& overlaid);

    /// The stages of a hybrid technique, without a frame of it.
    std::vector<StageText> stages(const Technique& technique);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon
