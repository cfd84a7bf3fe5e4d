#include "cli/bench_frames.h"

#include "casegen/standalone.h"
#include "cli/progress.h"
#include "cli/rendering.h"
#include "cli/view.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::cli {
namespace {

constexpr const char* demo = "demo";

/// A path below the source tree is the same name everywhere: what the baseline's scenes are called.
std::filesystem::path path_of(const std::string& name) {
    const std::filesystem::path in_tree = std::filesystem::path(GNOMON_SOURCE_DIR) / name;
    return !std::filesystem::exists(name) && std::filesystem::exists(in_tree) ? in_tree
                                                                              : std::filesystem::path(name);
}

} // namespace

std::vector<std::string> default_scenes() { return {demo, "fixtures/scenes/hybrid/thin_ramp.obj"}; }

std::vector<FrameWork> frame_work(const std::vector<std::string>& scenes,
                                  const std::optional<measure::Baseline>& baseline) {
    std::vector<FrameWork> work;
    for (const std::string& name : scenes) {
        if (std::ranges::count(scenes, name) > 1) throw Error("--scenes has {} twice", name);
        if (name == "none") throw Error("--scenes none stands alone");
        FrameWork one;
        one.scene = scene_of(name == demo ? "" : path_of(name).string());
        ViewOptions options;
        options.size = "480x360";
        int shadow_map = 512;
        if (baseline)
            for (const measure::SceneRecord& known : baseline->scenes)
                if (known.scene == name) {
                    options.size = fmt::format("{}x{}", known.width, known.height);
                    shadow_map = known.shadow_map;
                }
        View view = view_of(options, shadow_map, one.scene, LightFit::visible_points);
        if (name == demo) view = demo_view(one.scene, view.settings);
        one.view = {name, view.camera, view.light, view.settings};
        work.push_back(std::move(one));
    }
    return work;
}

std::vector<measure::SceneResult> measure_frames(const std::vector<FrameWork>& work,
                                                 const measure::BenchOptions& options) {
    std::vector<measure::SceneResult> results;
    if (work.empty()) return results;
    std::vector<Technique> techniques;
    for (const std::string& name : technique_names())
        if (name != "auto") techniques.push_back(technique_by_name(name));
    Progress progress("measuring techniques");
    gpu::Device device(options.device);
    for (const FrameWork& one : work) {
        progress.show(results.size(), work.size());
        results.push_back(measure::measure_scene(device, kernel_sources(options.kernels), one.scene, one.view,
                                                 techniques, static_cast<int>(options.rounds)));
    }
    return results;
}

} // namespace gnomon::cli
