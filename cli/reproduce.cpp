#include "casegen/standalone.h"
#include "cli/commands.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/reproduce/compare.h"
#include "cli/reproduce/measure.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>

namespace gnomon::cli {
namespace {

struct ReproduceCommand {
    std::string what = "thesis", scene, json;
    std::vector<int> maps{512, 1024, 2048, 4096};
    std::vector<std::string> views;
};

constexpr const char* scene_file = "thesis_bench_normals.ply";

/// Empty: the user has not said where the model is.
std::string scene_path(const ReproduceCommand& options) {
    if (!options.scene.empty()) return options.scene;
    const char* folder = std::getenv("GNOMON_SCENES");
    return folder == nullptr || *folder == '\0' ? "" : (std::filesystem::path(folder) / scene_file).string();
}

std::vector<ThesisView> views_of(const ReproduceCommand& options) {
    if (options.views.empty()) return thesis_views();
    std::vector<ThesisView> views;
    for (const ThesisView& view : thesis_views())
        if (std::ranges::find(options.views, view.name) != options.views.end()) views.push_back(view);
    return views;
}

/// The image sizes that the thesis takes, and with which maps: all at 1024 x 1024, one at the others.
std::vector<std::pair<glm::ivec2, std::vector<int>>> sizes_of(const std::vector<int>& maps) {
    std::vector<std::pair<glm::ivec2, std::vector<int>>> sizes{{{1024, 1024}, maps}};
    if (std::ranges::find(maps, 1024) != maps.end()) {
        sizes.push_back({{512, 512}, {1024}});
        sizes.push_back({{1920, 1080}, {1024}});
    }
    return sizes;
}

nlohmann::ordered_json key_json(const CountKey& key) {
    return {{"view", key.view}, {"width", key.width},         {"height", key.height},
            {"map", key.map},   {"technique", key.technique}, {"quantity", key.quantity}};
}

std::string json_of(const Scene& scene, const gpu::Device& device, const std::vector<Compared>& compared,
                    const Counts& counts) {
    nlohmann::ordered_json cells = nlohmann::ordered_json::array(), ours = nlohmann::ordered_json::array();
    for (const Compared& cell : compared) {
        nlohmann::ordered_json entry{{"table", cell.printed.table}};
        entry.update(key_json(cell.printed.key));
        entry["printed"] = cell.printed.value;
        entry["here"] = cell.ours;
        entry["difference"] = cell.difference();
        entry["target"] = cell.share ? nlohmann::ordered_json(*cell.share) : nlohmann::ordered_json();
        entry["holds"] = cell.holds();
        cells.push_back(std::move(entry));
    }
    for (const auto& [key, value] : counts) {
        nlohmann::ordered_json entry = key_json(key);
        entry["here"] = value;
        ours.push_back(std::move(entry));
    }
    const nlohmann::ordered_json report{
        {"gnomon", GNOMON_VERSION},     {"scene", scene.name}, {"triangles", scene.triangles.size()},
        {"device", device.info().name}, {"compared", cells},   {"counts", ours}};
    return report.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void run(const ReproduceCommand& options, const Common& common) {
    const std::string path = scene_path(options);
    if (path.empty()) {
        fmt::print(
            "skipped: the thesis's model is not part of gnomon; pass its PLY file with --scene, or name the "
            "folder that holds {} in GNOMON_SCENES\n",
            scene_file);
        return;
    }
    const std::vector<PrintedCount> printed =
        read_printed_counts(GNOMON_SOURCE_DIR "/fixtures/thesis/counts.csv");
    const Scene scene = scene_of(path);
    if (!options.json.empty()) require_writable(options.json);
    gpu::Device device(common.device);
    const glsl::Sources sources = kernel_sources(common.kernels);

    const std::vector<ThesisView> views = views_of(options);
    const auto sizes = sizes_of(options.maps);
    Counts counts;
    Progress progress("counting");
    std::size_t done = 0;
    for (const ThesisView& view : views)
        for (const auto& size : sizes) {
            progress.show(done++, views.size() * sizes.size());
            count_view(device, sources, scene, view, size.first.x, size.first.y, size.second, counts);
        }
    require_no_validation_messages();

    const std::vector<Compared> compared = compare_counts(printed, counts);
    if (!options.json.empty()) write_file(options.json, json_of(scene, device, compared, counts));
    fmt::print("{}\n{}", compared_tables(compared), compared_summary(compared));
}

} // namespace

void add_reproduce(CLI::App& app, Common& common) {
    CLI::App* verb = app.add_subcommand(
        "reproduce", "count pixels as a publication did, beside the counts that it prints");
    auto options = std::make_shared<ReproduceCommand>();
    verb->add_option("WHAT", options->what, "thesis: conservative shadow maps with adjacency (CRSMA)")
        ->check(CLI::IsMember({"thesis"}))
        ->capture_default_str();
    verb->add_option("--scene", options->scene,
                     fmt::format("the thesis's model (default: {} in the folder GNOMON_SCENES)", scene_file))
        ->check(not_empty());
    verb->add_option("--map-sizes", options->maps, "texels on a side of the shadow maps")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({512, 1024, 2048, 4096}))
        ->capture_default_str();
    std::vector<std::string> names;
    for (const ThesisView& view : thesis_views()) names.push_back(view.name);
    verb->add_option("--views", options->views,
                     fmt::format("some of {} (default: all)", fmt::join(names, ", ")))
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(names));
    verb->add_option("--json", options->json, "JSON file to write: every count")->check(not_empty());
    verb->footer(
        "  gnomon reproduce thesis --scene thesis_bench_normals.ply\n"
        "  gnomon reproduce thesis --views Flowers-With,Trees-Against --map-sizes 1024 --json counts.json");
    verb->callback([options, &common] { run(*options, common); });
}

} // namespace gnomon::cli
