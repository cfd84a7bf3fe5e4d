#include "casegen/check.h"
#include "casegen/demo_scene.h"
#include "casegen/standalone.h"
#include "cli/commands.h"
#include "cli/progress.h"
#include "cli/rendering.h"
#include "cli/report.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <memory>

namespace gnomon::cli {
namespace {

int check_all(const Common& common, nlohmann::ordered_json& report) {
    const std::vector<const Case*> cases = find_cases("");
    CheckOptions options;
    options.kernels = common.kernels;
    options.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    options.device = common.device;
    std::vector<CheckReport> reports;
    {
        Progress progress("checking kernels");
        reports = check(cases, options,
                        [&](std::size_t done) { progress.show(done, cases.size() * options.samples); });
    }
    fmt::print("{}\n", check_text(reports, {}));
    report["kernels"] = nlohmann::ordered_json::parse(check_json(reports, {}))["kernels"];
    for (const CheckReport& r : reports)
        if (r.verdict != Verdict::pass) return 1;
    return 0;
}

/// Against the light, so that the shadows of fence and lattice fall towards the viewer.
Camera demo_camera(const Scene& scene) {
    Camera camera = default_camera(scene.bounds(), 1);
    camera.position = {2.4f, 2.2f, 7.4f};
    camera.direction = {-0.30f, -0.36f, -0.9f};
    camera.fov = 40;
    return camera;
}
constexpr glm::vec3 demo_light{0.45f, -0.62f, 0.5f};

/// The same part of every picture, beside one another on white: where shadow edges of all slopes can be
/// compared.
Image side_by_side(const std::vector<Judged>& all) {
    constexpr int x0 = 250, y0 = 340, width = 480, height = 330, gap = 6;
    const int count = static_cast<int>(all.size());
    Image strip(count * width + (count - 1) * gap, height, {255, 255, 255});
    for (int i = 0; i < count; ++i)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                strip.at(i * (width + gap) + x, y) =
                    all[static_cast<std::size_t>(i)].rendering.image.at(x0 + x, y0 + y);
    return strip;
}

int run(const std::filesystem::path& folder, const Common& common) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error("{}: cannot be made a folder: {}", folder.string(), error.message());
    const std::filesystem::path report_path = folder / "report.json";
    require_writable(report_path);

    nlohmann::ordered_json report{{"gnomon", GNOMON_VERSION}};
    const int exit_code = check_all(common, report);

    const Scene scene = demo_scene();
    const Camera camera = demo_camera(scene);
    const Light light{.direction = demo_light};
    const ViewSettings settings;
    gpu::Device device(common.device);
    Renderer renderer(device, kernel_sources(common.kernels), scene, camera, light, settings);
    std::vector<Judged> all;
    std::vector<std::string> names = technique_names();
    const Rendering truth = renderer.render(technique_by_name("raytraced"));
    {
        Progress progress("rendering");
        for (const std::string& name : names) {
            if (name == "none") continue;
            Judged judged{name, name == "raytraced" ? truth : renderer.render(technique_by_name(name)), {}};
            judged.counts = count_pixels(renderer.surfaces(), judged.rendering.visibility, truth.visibility);
            write_png(folder / (name + ".png"), judged.rendering.image);
            if (name != "raytraced")
                write_png(folder / (name + "_errors.png"),
                          false_colours(renderer.surfaces(), judged.rendering.visibility, truth.visibility,
                                        settings.width, settings.height));
            all.push_back(std::move(judged));
            progress.show(all.size(), names.size() - 1);
        }
    }
    require_no_validation_messages();
    write_png(folder / "side_by_side.png", side_by_side(all));
    report["device"] = device.info().name;
    report["scene"] = scene.name;
    report["triangles"] = scene.triangles.size();
    report["view"] = view_json(camera, light, settings);
    for (const Judged& judged : all) report["techniques"].push_back(judged_json(judged));
    write_file(report_path, report.dump(2) + "\n");
    fmt::print("{} x {} pixels, shadow map {}, {} triangles, {}\n{}", settings.width, settings.height,
               settings.shadow_map, scene.triangles.size(), device.info().name, judged_table(all));
    fmt::print("\npictures and report.json are in {}\n", folder.string());
    return exit_code;
}

} // namespace

void add_demo(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "demo", "check every kernel, then render the demo scene with every technique and judge it");
    auto folder = std::make_shared<std::filesystem::path>("out/demo");
    verb->add_option("--out", *folder, "folder for pictures and report.json")->capture_default_str();
    verb->callback([folder, &common, &exit_code] { exit_code = run(*folder, common); });
}

} // namespace gnomon::cli
