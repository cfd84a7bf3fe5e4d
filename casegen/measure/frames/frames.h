// Techniques of the pipeline on a scene: what each one's image has wrong, and what its frame takes.
#pragma once

#include "casegen/measure/timing.h"
#include "runtime/pipeline/judge.h"
#include "runtime/pipeline/renderer.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

struct FrameRow {
    std::string technique;
    bool exact = false; ///< it promises the ray tracer's image
    PixelCounts counts;
    std::size_t differing = 0; ///< pixels whose visibility is not the ray tracer's, bit for bit
    double rmse = 0;           ///< of the visibility, over pixels that face the light; NaN counts as 1
    std::size_t rays = 0;      ///< of a hybrid: pixels that it traced
    TechniqueTimes times;      ///< without images; no rounds if no time was taken
    /// Over the yardstick's: nsm's of the same rounds, or the first technique's where nsm is not among them.
    Ratio over_yardstick;
    Image image;                             ///< as it is shaded
    Image errors;                            ///< false_colours
    std::optional<std::size_t> dominated_by; ///< another row; nothing without times
};

/// What a scene is looked at with.
struct FrameView {
    std::string scene; ///< as the user named it: "demo", a file
    Camera camera;
    Light light;
    ViewSettings settings;
};

struct SceneResult {
    FrameView view;
    std::size_t triangles = 0;
    std::vector<FrameRow> rows; ///< in the order of the techniques
    std::string yardstick;      ///< the technique that ratios are over
    Image truth;                ///< ray-traced
    /// How far a round is from its technique's median: the median of all of them, as a fraction; no less than
    /// least_noise.
    double noise = 0;
};

/// All but the times is the same on any number of cores. `rounds`: how often each technique is timed, all of
/// them in turn; 0: no times. Throws Error.
SceneResult measure_scene(gpu::Device& device, const glsl::Sources& sources, const Scene& scene,
                          const FrameView& view, const std::vector<Technique>& techniques, int rounds);

/// Every exact technique whose image is not the ray tracer's, one line each.
std::vector<std::string> broken_promises(const SceneResult& result);

} // namespace gnomon::measure
