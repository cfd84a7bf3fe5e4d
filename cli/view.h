// What is seen, from where, and in which light: the options that render and census share.
#pragma once

#include "runtime/pipeline/view.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gnomon::cli {

struct ViewOptions {
    std::string receiver = "plane";
    std::string camera_position, camera_direction, light_direction, light_position, size = "1024x768";
    std::optional<float> fov, near, far;
    float light_fov = 90, bias = 0;
    std::string light_fit; ///< empty: the verb's default
};

/// All but SCENE and --shadow-map.
void add_view_options(CLI::App& verb, ViewOptions& options);

struct View {
    Camera camera;
    Light light;
    ViewSettings settings;
};

/// Throws Error naming the option that is malformed, out of range, or leaves no direction to look in. `fit`
/// is what a directional light's map covers unless the options say.
View view_of(const ViewOptions& options, int shadow_map, const Scene& scene,
             LightFit fit = LightFit::seen_box);

/// The demo scene against the light, so that the shadows of fence and lattice fall towards the viewer.
View demo_view(const Scene& scene, const ViewSettings& settings);

/// "box", "camera", "visible": what --light-fit takes.
const char* to_string(LightFit fit);

/// The demo scene for an empty path. Prints the file's warnings.
Scene scene_of(const std::string& path);

/// --reading NAME=VALUE, as often as one likes; readings_for reads them.
void add_reading_option(CLI::App& verb, std::vector<std::string>& settings);

/// A check for options that must not be "".
CLI::Validator not_empty();

/// A check for options that name a folder to read: a mistyped one must not look like an empty one. A
/// default may be missing.
CLI::Validator is_folder();

} // namespace gnomon::cli
