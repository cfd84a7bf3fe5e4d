#include "casegen/measure/hybrid/report.h"
#include "casegen/measure/hybrid/tables.h"
#include "casegen/measure/report.h"
#include "casegen/measure/timing.h"
#include "casegen/standalone.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace gnomon::cli {
namespace {

struct BenchHybridCommand {
    std::string scene;
    ViewOptions view;
    std::vector<std::string> sizes{"512x512", "1024x1024", "1920x1080"};
    measure::HybridBenchOptions bench{.shadow_maps = {512, 1024, 2048, 4096}};
    std::filesystem::path out;
};

/// Throws Error if one is there twice.
template <typename T>
void require_different(const std::vector<T>& values, const char* option) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::find(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(i), values[i]) !=
            values.begin() + static_cast<std::ptrdiff_t>(i))
            throw Error("{} has {} twice", option, values[i]);
}

int run(const BenchHybridCommand& options, const Common& common) {
    require_different(options.sizes, "--sizes");
    require_different(options.bench.shadow_maps, "--shadow-maps");
    require_different(options.bench.techniques, "--techniques");
    measure::require_hybrids(options.bench.techniques);
    for (const std::string& size : options.sizes) parse_size(size, "--sizes");
    const Scene scene = scene_of(options.scene);
    // Whatever a view refuses, it refuses before anything is measured.
    std::vector<View> views;
    for (const std::string& size : options.sizes)
        for (const int map : options.bench.shadow_maps) {
            ViewOptions view = options.view;
            view.size = size;
            views.push_back(view_of(view, map, scene, LightFit::visible_points));
        }
    if (!options.out.empty()) measure::require_report_folder(options.out);

    gpu::Device device(common.device);
    measure::HybridBench bench{
        measure::machine(device), scene.name, scene.triangles.size(), options.bench.rounds, {}};
    {
        Progress progress("measuring");
        for (const View& view : views) {
            progress.show(bench.combinations.size(), views.size());
            Renderer renderer(device, kernel_sources(common.kernels), scene, view.camera, view.light,
                              view.settings);
            bench.combinations.push_back(measure::measure_combination(renderer, options.bench));
            measure::HybridCombination& made = bench.combinations.back();
            made.width = view.settings.width;
            made.height = view.settings.height;
            made.shadow_map = view.settings.shadow_map;
        }
    }
    require_no_validation_messages();
    if (!options.out.empty()) measure::write_report(options.out, bench);
    fmt::print("{}", measure::to_text(bench));
    if (!options.out.empty())
        fmt::print("Picture and tables are in {}\n", (options.out / "report.html").string());
    const std::vector<std::string> broken = measure::broken_promises(bench);
    for (const std::string& line : broken) fmt::print("{}\n", line);
    return broken.empty() ? 0 : 1;
}

} // namespace

void add_bench_hybrid(CLI::App& bench, Common& common, int& exit_code) {
    CLI::App* verb = bench.add_subcommand(
        "hybrid", "hybrid shadows against a ray for every pixel: time, rays, memory, errors, break-even");
    auto options = std::make_shared<BenchHybridCommand>();
    verb->add_option("SCENE", options->scene, "glTF, OBJ or PLY file (default: the demo scene)")
        ->check(not_empty());
    verb->add_option("--sizes", options->sizes, "viewports, WIDTHxHEIGHT, parted by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    verb->add_option("--shadow-maps", options->bench.shadow_maps, "texels on a side, parted by commas")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    verb->add_option(
            "--techniques", options->bench.techniques,
            "which, parted by commas (default: all); raytraced is always measured, auto stands for the "
            "choice")
        ->delimiter(',')
        ->allow_extra_args(false);
    verb->add_option("--rounds", options->bench.rounds,
                     "how often each technique is timed; one more is discarded")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    verb->add_option("--out", options->out,
                     "folder for report.html, hybrid_pareto.svg, hybrid.json and hybrid.csv")
        ->check(not_empty());
    add_view_options(*verb, options->view);
    verb->remove_option(verb->get_option("--size")); // --sizes
    verb->footer("  gnomon bench hybrid city.glb --out out/hybrid\n"
                 "  gnomon bench hybrid --sizes 1024x1024 --shadow-maps 1024 --techniques lists,auto");
    // BenchHybridCommand that are not its own fall through to bench, whose they are, and would be ignored.
    verb->callback([options, &bench, &common, &exit_code] {
        for (const CLI::Option* option : bench.get_options())
            if (option->count() > 0) throw Error("{} is not an option of bench hybrid", option->get_name());
        exit_code = run(*options, common);
    });
}

} // namespace gnomon::cli
