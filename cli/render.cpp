#include "casegen/demo_scene.h"
#include "casegen/standalone.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/rendering.h"
#include "cli/report.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>

namespace gnomon::cli {
namespace {

struct Options {
    std::string scene, technique = "smsr", receiver = "plane";
    std::string camera_position, camera_direction, light_direction, light_position, size = "1024x768";
    std::optional<float> fov, near, far;
    float light_fov = 90, bias = 0;
    int shadow_map = 1024, frames = 5;
    std::filesystem::path report, image, errors;
};

/// From a position to the scene's centre. Throws Error if that is where the position is.
glm::vec3 towards_centre(const Scene& scene, glm::vec3 position, const char* what) {
    const glm::vec3 direction = scene.bounds().centre() - position;
    if (direction == glm::vec3(0))
        throw Error("--{0}-position is the scene's centre; say where it looks with --{0}-direction", what);
    return direction;
}

/// Throws Error before minutes of work if one of the outputs cannot be written, or would replace another.
void require_outputs(const Options& options) {
    const std::array outputs{std::pair{"--report", &options.report}, std::pair{"--image", &options.image},
                             std::pair{"--errors", &options.errors}};
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [name, path] = outputs[i];
        if (path->empty()) continue;
        require_writable(*path);
        for (std::size_t k = 0; k < i; ++k)
            if (std::filesystem::weakly_canonical(*path) ==
                std::filesystem::weakly_canonical(*outputs[k].second))
                throw Error("{} and {} both name '{}'; each needs a file of its own", outputs[k].first, name,
                            path->string());
    }
}

void run(const Options& options, const Common& common) {
    const Scene scene = options.scene.empty() ? demo_scene() : load_scene(options.scene);
    for (const std::string& warning : scene.warnings)
        fmt::print(stderr, "gnomon: {}: {}\n", scene.name, warning);

    ViewSettings settings;
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
    settings.shadow_map = options.shadow_map;
    settings.bias = options.bias;
    settings.receiver_plane = options.receiver == "plane";
    require_valid(camera, light, settings);
    require_outputs(options);

    Progress progress("rendering");
    gpu::Device device(common.device);
    Renderer renderer(device, kernel_sources(common.kernels), scene, camera, light, settings);
    const Technique truth_technique = technique_by_name("raytraced");
    progress.show(0, 2);
    const Rendering truth = renderer.render(truth_technique, options.frames);
    progress.show(1, 2);
    Judged judged{options.technique, {}, {}};
    judged.rendering = options.technique == "raytraced"
                           ? truth
                           : renderer.render(technique_by_name(options.technique), options.frames);
    judged.counts = count_pixels(renderer.surfaces(), judged.rendering.visibility, truth.visibility);
    require_no_validation_messages();

    if (!options.image.empty()) write_png(options.image, judged.rendering.image);
    if (!options.errors.empty())
        write_png(options.errors, false_colours(renderer.surfaces(), judged.rendering.visibility,
                                                truth.visibility, settings.width, settings.height));
    nlohmann::ordered_json report{{"gnomon", GNOMON_VERSION},
                                  {"scene", scene.name},
                                  {"triangles", scene.triangles.size()},
                                  {"device", device.info().name},
                                  {"frames", options.frames},
                                  {"view", view_json(camera, light, settings)}};
    report.update(judged_json(judged));
    if (!options.report.empty())
        write_file(options.report,
                   report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    fmt::print("{}", judged_table({judged}));
    const PixelCounts& c = judged.counts;
    if (c.covered == 0) fmt::print(stderr, "gnomon: the camera sees nothing of the scene\n");
    fmt::print("{} pixels see a surface: {} face the light ({} lit, {} shadowed by truth), {} face away\n",
               c.covered, c.facing, c.truly_lit, c.truly_shadowed, c.facing_away);
    for (const Step& step : judged.rendering.steps)
        fmt::print("  {:<12} {:8.2f} ms\n", step.name, step.milliseconds);
}

} // namespace

void add_render(CLI::App& app, Common& common) {
    const CLI::Validator not_empty([](std::string& value) { return value.empty() ? "is empty" : ""; }, "");
    CLI::App* verb =
        app.add_subcommand("render", "render a scene and judge its shadows against ray-traced truth");
    auto options = std::make_shared<Options>();
    verb->add_option("SCENE", options->scene, "glTF, OBJ or PLY file (default: the demo scene)")
        ->check(not_empty);
    verb->add_option("--technique", options->technique, "how visibility is found")
        ->check(CLI::IsMember(technique_names()))
        ->capture_default_str();
    verb->add_option("--camera-position", options->camera_position, "X,Y,Z (default: sees the whole scene)")
        ->check(not_empty);
    verb->add_option("--camera-direction", options->camera_direction,
                     "X,Y,Z (default: towards the scene's centre)")
        ->check(not_empty);
    verb->add_option("--fov", options->fov, "vertical field of view in degrees (default: 50)");
    verb->add_option("--near", options->near, "nearest distance seen (default: from the scene's size)");
    verb->add_option("--far", options->far, "farthest distance seen (default: from the scene's size)");
    verb->add_option("--light-direction", options->light_direction,
                     "X,Y,Z: the way light travels (default: 0.5,-0.7,0.3)")
        ->check(not_empty);
    CLI::Option* light_position =
        verb->add_option(
                "--light-position", options->light_position,
                "X,Y,Z of a perspective light, which looks along --light-direction (default: towards the "
                "scene's centre); without it the light is directional")
            ->check(not_empty);
    verb->add_option("--light-fov", options->light_fov, "a perspective light's field of view in degrees")
        ->needs(light_position)
        ->capture_default_str();
    verb->add_option("--size", options->size, "WIDTHxHEIGHT of the image in pixels")->capture_default_str();
    verb->add_option("--shadow-map", options->shadow_map, "texels on a side of the shadow map")
        ->capture_default_str();
    verb->add_option("--bias", options->bias,
                     "of the shadow test, in world units (default: rounding of the depth range)");
    verb->add_option("--receiver", options->receiver,
                     "what is tested against neighbouring texels: the receiver's plane, or its depth alone")
        ->check(CLI::IsMember({"plane", "depth"}))
        ->capture_default_str();
    verb->add_option("--frames", options->frames,
                     "frames that times are the median of; one more is discarded")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    verb->add_option("--report", options->report, "JSON file to write")->check(not_empty);
    verb->add_option("--image", options->image, "PNG file to write: the shaded frame")->check(not_empty);
    verb->add_option("--errors", options->errors,
                     "PNG file to write: red lit but truly in shadow, blue shadowed but truly lit")
        ->check(not_empty);
    verb->footer(
        "  gnomon render --technique smsr --image smsr.png --errors wrong.png\n"
        "  gnomon render city.glb --shadow-map 2048 --light-direction=-0.5,-0.65,0.35 --report city.json");
    verb->callback([options, &common] { run(*options, common); });
}

} // namespace gnomon::cli
