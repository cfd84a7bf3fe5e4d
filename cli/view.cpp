#include "cli/view.h"

#include "casegen/demo_scene.h"
#include "casegen/readings.h"
#include "cli/parse.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gnomon::cli {
namespace {

/// From a position to the scene's centre. Throws Error if that is where the position is.
glm::vec3 towards_centre(const Scene& scene, glm::vec3 position, const char* what) {
    const glm::vec3 direction = scene.bounds().centre() - position;
    if (direction == glm::vec3(0))
        throw Error("--{0}-position is the scene's centre; say where it looks with --{0}-direction", what);
    return direction;
}

} // namespace

CLI::Validator not_empty() {
    return CLI::Validator([](std::string& value) { return value.empty() ? "is empty" : ""; }, "");
}

CLI::Validator is_folder() {
    return CLI::Validator(
        [](std::string& value) {
            return std::filesystem::is_directory(value) ? "" : fmt::format("'{}' is no folder", value);
        },
        "");
}

void add_reading_option(CLI::App& verb, std::vector<std::string>& settings) {
    std::string names;
    for (const Reading& reading : readings())
        names +=
            fmt::format("{}{}={}", names.empty() ? "" : ", ", reading.name, fmt::join(reading.values, "|"));
    verb.add_option(
            "--reading", settings,
            "NAME=VALUE: how RSMSS's document is read where it is open (docs/decisions.md; the first value "
            "is the default): " +
                names)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_view_options(CLI::App& verb, ViewOptions& options) {
    verb.add_option("--camera-position", options.camera_position, "X,Y,Z (default: sees the whole scene)")
        ->check(not_empty());
    verb.add_option("--camera-direction", options.camera_direction,
                    "X,Y,Z (default: towards the scene's centre)")
        ->check(not_empty());
    verb.add_option("--fov", options.fov, "vertical field of view in degrees (default: 50)");
    verb.add_option("--near", options.near, "nearest distance seen (default: from the scene's size)");
    verb.add_option("--far", options.far, "farthest distance seen (default: from the scene's size)");
    verb.add_option("--light-direction", options.light_direction,
                    "X,Y,Z: the way light travels (default: 0.5,-0.7,0.3)")
        ->check(not_empty());
    CLI::Option* light_position =
        verb.add_option(
                "--light-position", options.light_position,
                "X,Y,Z of a perspective light, which looks along --light-direction (default: towards the "
                "scene's centre); without it the light is directional")
            ->check(not_empty());
    verb.add_option("--light-fov", options.light_fov, "a perspective light's field of view in degrees")
        ->needs(light_position)
        ->capture_default_str();
    verb.add_option(
            "--light-fit", options.light_fit,
            "what a directional light's map covers: what the camera can see of the scene's box, the camera's "
            "frustum, or the visible points that face the light (default: box; visible for hybrids)")
        ->check(CLI::IsMember({"box", "camera", "visible"}));
    verb.add_option("--size", options.size, "WIDTHxHEIGHT of the image in pixels")->capture_default_str();
    verb.add_option("--bias", options.bias,
                    "of the shadow test, in world units (default: rounding of the depth range)");
    verb.add_option("--receiver", options.receiver,
                    "what is tested against neighbouring texels: the receiver's plane, or its depth alone")
        ->check(CLI::IsMember({"plane", "depth"}))
        ->capture_default_str();
}

const char* to_string(LightFit fit) {
    switch (fit) {
    case LightFit::camera_frustum:
        return "camera";
    case LightFit::visible_points:
        return "visible";
    case LightFit::seen_box:
        break;
    }
    return "box";
}

View view_of(const ViewOptions& options, int shadow_map, const Scene& scene, LightFit fit) {
    ViewSettings settings;
    settings.light_fit = fit;
    for (const LightFit named : {LightFit::seen_box, LightFit::camera_frustum, LightFit::visible_points})
        if (options.light_fit == to_string(named)) settings.light_fit = named;
    std::tie(settings.width, settings.height) = parse_size(options.size, "--size");
    const bool has_area = settings.width > 0 && settings.height > 0; // else require_valid says so
    Camera camera = default_camera(scene.bounds(), has_area ? static_cast<float>(settings.width) /
                                                                  static_cast<float>(settings.height)
                                                            : 1);
    if (!options.camera_position.empty())
        camera.position = parse_vector(options.camera_position, "--camera-position");
    if (!options.camera_direction.empty())
        camera.direction = parse_vector(options.camera_direction, "--camera-direction");
    else if (!options.camera_position.empty())
        camera.direction = towards_centre(scene, camera.position, "camera");
    camera.fov = options.fov.value_or(camera.fov);
    camera.near = options.near.value_or(camera.near);
    camera.far = options.far.value_or(camera.far);
    Light light;
    light.fov = options.light_fov;
    if (!options.light_position.empty()) {
        light.position = parse_vector(options.light_position, "--light-position");
        if (options.light_direction.empty())
            light.direction = towards_centre(scene, *light.position, "light");
    }
    if (!options.light_direction.empty())
        light.direction = parse_vector(options.light_direction, "--light-direction");
    settings.shadow_map = shadow_map;
    settings.bias = options.bias;
    settings.receiver_plane = options.receiver == "plane";
    require_valid(camera, light, settings);
    return {camera, light, settings};
}

View demo_view(const Scene& scene, const ViewSettings& settings) {
    Camera camera = default_camera(scene.bounds(), 1);
    camera.position = {2.4f, 2.2f, 7.4f};
    camera.direction = {-0.30f, -0.36f, -0.9f};
    camera.fov = 40;
    Light light;
    light.direction = {0.45f, -0.62f, 0.5f};
    return {camera, light, settings};
}

Scene scene_of(const std::string& path) {
    Scene scene = path.empty() ? demo_scene() : load_scene(path);
    for (const std::string& warning : scene.warnings)
        fmt::print(stderr, "gnomon: {}: {}\n", scene.name, warning);
    return scene;
}

} // namespace gnomon::cli
