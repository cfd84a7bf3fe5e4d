#include "casegen/census.h"
#include "casegen/demo_scene.h"
#include "casegen/measure/bench.h"
#include "casegen/measure/report.h"
#include "casegen/standalone.h"
#include "casegen/technique.h"
#include "cli/atlas_page.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/rendering.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <array>
#include <memory>

namespace gnomon::cli {
namespace {

/// How often each case occurs among the renderer's pixels, as the atlas shows it.
atlas::Census census_of(Renderer& renderer) {
    atlas::Census census{"demo scene", {}};
    for (const std::string& name : numbered_techniques()) {
        const Family& family = technique_family(name);
        const Counts counts = renderer.census(technique_of(family));
        for (const CaseShare& share : case_shares(family, std::span(&counts, 1)))
            census.shares[family.name][share.c->number] = share.share;
    }
    return census;
}

/// Checks every kernel and tells of each in the atlas. Returns the exit code.
int check_all(const Common& common, atlas::Census census, const std::filesystem::path& page,
              const std::string& replay, nlohmann::ordered_json& report) {
    atlas::Options options = atlas_options(common);
    options.censuses = {std::move(census)};
    atlas::Atlas atlas;
    {
        Progress progress("checking kernels");
        const std::size_t total = samples_asked_for(find_cases(""), options.check);
        atlas =
            atlas::make_atlas(catalogue(), options, [&](std::size_t done) { progress.show(done, total); });
    }
    write_atlas(page, atlas, common, replay);
    const std::vector<CheckReport> reports = reports_of(atlas);
    fmt::print("{}\n", check_text(reports, replay));
    report["kernels"] = nlohmann::ordered_json::parse(check_json(reports, replay))["kernels"];
    return atlas.passes() ? 0 : 1;
}

/// Error against run time of the radiance's forms, as `bench` measures it, in less time.
std::filesystem::path measure_radiance(const std::filesystem::path& folder, const Common& common) {
    measure::BenchOptions options;
    options.samples = 512;
    options.repeats = 2;
    options.rounds = 3;
    options.kernels = common.kernels;
    options.device = common.device;
    Progress progress("measuring");
    measure::Report report;
    report.bench = measure::bench(measure::group(measure::find_variants("integral/radiance"),
                                                 std::array{Trigonometry::portable}, common.kernels),
                                  options, [&](std::size_t done) { progress.show(done, 1); });
    measure::write_report(folder, report);
    return folder / "report.html";
}

/// The same part of every picture, three in a row on white: where shadow edges of all slopes can be compared.
Image side_by_side(const std::vector<Judged>& all) {
    constexpr int x0 = 250, y0 = 340, width = 480, height = 330, gap = 6, columns = 3;
    const int count = static_cast<int>(all.size()), rows = (count + columns - 1) / columns;
    Image sheet(columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap, {255, 255, 255});
    for (int i = 0; i < count; ++i)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                sheet.at(i % columns * (width + gap) + x, i / columns * (height + gap) + y) =
                    all[static_cast<std::size_t>(i)].rendering.image.at(x0 + x, y0 + y);
    return sheet;
}

int run(const std::filesystem::path& folder, const Common& common, const std::string& replay) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error("{}: cannot be made a folder: {}", folder.string(), error.message());
    const std::filesystem::path report_path = folder / "report.json";
    require_writable(report_path);

    const std::filesystem::path page = require_atlas_folder(folder / "atlas", common);
    measure::require_report_folder(folder / "radiance");

    const Scene scene = demo_scene();
    const auto [camera, light, settings] = demo_view(scene, ViewSettings());
    gpu::Device device(common.device);
    Renderer renderer(device, kernel_sources(common.kernels), scene, camera, light, settings);

    nlohmann::ordered_json report{{"gnomon", GNOMON_VERSION}};
    const int exit_code = check_all(common, census_of(renderer), page, replay, report);
    const std::filesystem::path radiance = measure_radiance(folder / "radiance", common);
    std::vector<Judged> all;
    std::vector<std::string> names = technique_names();
    std::erase(names, "none");
    // Hybrids draw the ray tracer's picture, or nearly: `render` and `bench hybrid` show what they cost.
    std::erase_if(names,
                  [](const std::string& name) { return name == "auto" || find_hybrid(name) != nullptr; });
    const Rendering truth = renderer.render(technique_by_name("raytraced"));
    {
        Progress progress("rendering");
        for (const std::string& name : names) {
            Judged judged{name, name == "raytraced" ? truth : renderer.render(technique_by_name(name)), {}};
            judged.counts = count_pixels(renderer.surfaces(), judged.rendering.visibility, truth.visibility);
            write_png(folder / (name + ".png"), judged.rendering.image);
            if (name != "raytraced")
                write_png(folder / (name + "_errors.png"),
                          false_colours(renderer.surfaces(), judged.rendering.visibility, truth.visibility,
                                        settings.width, settings.height));
            all.push_back(std::move(judged));
            progress.show(all.size(), names.size());
        }
    }
    require_no_validation_messages();
    write_png(folder / "side_by_side.png", side_by_side(all));
    report["device"] = device.info().name;
    report["scene"] = scene.name;
    report["triangles"] = scene.triangles.size();
    report["view"] = view_json(camera, light, settings);
    for (const Judged& judged : all) report["techniques"].push_back(judged_json(judged));
    write_file(report_path, report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    fmt::print("{} x {} pixels, shadow map {}, {} triangles, {}\n{}", settings.width, settings.height,
               settings.shadow_map, scene.triangles.size(), device.info().name, judged_table(all));
    fmt::print("\npictures and report.json are in {}, every case in {}, the radiance's forms in {}\n",
               folder.string(), page.string(), radiance.string());
    return exit_code;
}

} // namespace

void add_demo(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb =
        app.add_subcommand("demo", "check every kernel, show every case in an atlas, measure the "
                                   "radiance's forms, render the demo scene with every "
                                   "technique and judge it");
    auto folder = std::make_shared<std::filesystem::path>("out/demo");
    verb->add_option("--out", *folder,
                     "folder for pictures, report.json, atlas/index.html and radiance/report.html")
        ->capture_default_str();
    verb->callback(
        [folder, &app, &common, &exit_code] { exit_code = run(*folder, common, replay_options(app)); });
}

} // namespace gnomon::cli
