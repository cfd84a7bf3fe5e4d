// Every technique on scenes, as bench measures them.
#pragma once

#include "casegen/measure/baseline.h"
#include "casegen/measure/frames/frames.h"

#include <optional>
#include <string>
#include <vector>

namespace gnomon::cli {

/// A scene and how it is looked at.
struct FrameWork {
    Scene scene;
    measure::FrameView view;
};

/// What a report shows if nobody names scenes: the demo scene, and a ramp of thin strips.
std::vector<std::string> default_scenes();

/// Loads them: "demo", a file, or a file of the source tree by its path there. Small images over a coarse
/// map, where techniques differ; a scene of the baseline is seen as it was. Throws Error: no such file, a
/// scene twice.
std::vector<FrameWork> frame_work(const std::vector<std::string>& scenes,
                                  const std::optional<measure::Baseline>& baseline);

/// Every technique but auto, which is one of them. Shows its progress.
std::vector<measure::SceneResult> measure_frames(const std::vector<FrameWork>& work,
                                                 const measure::BenchOptions& options);

} // namespace gnomon::cli
