#include "casegen/census.h"
#include "casegen/csv.h"
#include "casegen/mask.h"
#include "casegen/standalone.h"
#include "cli/atlas_page.h"
#include "cli/commands.h"
#include "cli/explain.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/rendering.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>

namespace gnomon::cli {
namespace {

struct CensusCommand {
    std::vector<std::string> inputs;
    std::string technique = "smsr", outside = "clamp";
    ViewOptions view;
    std::vector<int> shadow_maps{1024};
    unsigned lights = 0; // 0: the one of `view`
    std::filesystem::path json, atlas;
    std::string of_views; // the first option given that only scenes have
};

bool is_mask(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension == ".png" || extension == ".txt";
}

/// What was counted, and how often each number was found.
struct Census {
    nlohmann::ordered_json what;
    Counts counts;
};

void count_views(const CensusCommand& options, const std::string& path, const Common& common,
                 gpu::Device& device, std::vector<Census>& found) {
    const Scene scene = scene_of(path);
    for (const int shadow_map : options.shadow_maps)
        for (unsigned i = 0; i < std::max(options.lights, 1u); ++i) {
            View view = view_of(options.view, shadow_map, scene);
            if (options.lights > 0) view.light.direction = spread_direction(i);
            Renderer renderer(device, kernel_sources(common.kernels), scene, view.camera, view.light,
                              view.settings);
            nlohmann::ordered_json what{{"scene", scene.name}};
            what.update(view_json(view.camera, view.light, view.settings));
            found.push_back({std::move(what), renderer.census(technique_by_name(options.technique))});
        }
}

nlohmann::ordered_json json_of(const CensusCommand& options, const Family& family,
                               const std::vector<Census>& found, const std::vector<CaseShare>& shares,
                               const gpu::Device& device) {
    nlohmann::ordered_json of_family = nlohmann::ordered_json::object(), cases, censuses;
    for (const CaseShare& s : shares) {
        of_family[std::to_string(s.c->number)] = s.mean;
        cases.push_back(nlohmann::ordered_json{{"number", s.c->number},
                                               {"name", s.c->name},
                                               {"count", s.count},
                                               {"share", s.share},
                                               {"mean", s.mean},
                                               {"deviation", s.deviation}});
    }
    for (const Census& census : found) {
        nlohmann::ordered_json counts = nlohmann::ordered_json::object();
        for (std::size_t number = 0; number < census.counts.size(); ++number)
            if (census.counts[number] > 0) counts[std::to_string(number)] = census.counts[number];
        nlohmann::ordered_json entry = census.what;
        entry["counts"] = counts;
        censuses.push_back(entry);
    }
    return {{"gnomon", GNOMON_VERSION},
            {"device", device.info().name},
            {"technique", options.technique},
            {"shares", {{family.name, of_family}}},
            {"cases", cases},
            {"censuses", censuses}};
}

/// The atlas with these shares beside those of the masks that it counts itself.
/// Returns the exit code: a kernel may fail.
int write_page(const std::filesystem::path& page, const Family& family, const std::vector<CaseShare>& shares,
               std::size_t censuses, const Common& common, const std::string& replay) {
    atlas::Options options = atlas_options(common);
    atlas::Census census{censuses == 1 ? "this census" : fmt::format("mean of {} censuses", censuses), {}};
    for (const CaseShare& s : shares) census.shares[family.name][s.c->number] = s.mean;
    options.censuses = {std::move(census)};
    const atlas::Atlas made = atlas::make_atlas(catalogue(), options);
    require_no_validation_messages();
    write_atlas(page, made, common, replay);
    fmt::print("{}", atlas_summary(made, page));
    return made.passes() ? 0 : 1;
}

int run(const CensusCommand& options, const Common& common, const std::string& replay) {
    const Family& family = technique_family(options.technique);
    if (!options.json.empty()) require_writable(options.json);
    std::filesystem::path page;
    if (!options.atlas.empty()) page = require_atlas_folder(options.atlas, common);
    std::vector<std::string> inputs = options.inputs;
    if (inputs.empty()) inputs.emplace_back(); // the demo scene
    const auto masks = static_cast<std::size_t>(std::ranges::count_if(inputs, is_mask));
    if (masks == inputs.size() && !options.of_views.empty())
        throw Error("{} says nothing about a mask; it is about how a scene is seen", options.of_views);

    std::vector<Census> found;
    Progress progress("counting");
    gpu::Device device(common.device);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (is_mask(inputs[i])) {
            Mask mask = load_mask(inputs[i]);
            mask.outside = parse_outside(options.outside, "--outside");
            found.push_back({{{"mask", std::filesystem::path(inputs[i]).filename().string()},
                              {"size", {mask.width, mask.height}}},
                             mask_census(device, kernel_sources(common.kernels), family, mask)});
        } else {
            count_views(options, inputs[i], common, device, found);
        }
        progress.show(i + 1, inputs.size());
    }
    require_no_validation_messages();

    std::vector<Counts> censuses;
    std::uint64_t of_cases = 0, all = 0;
    for (const Census& census : found) {
        censuses.push_back(census.counts);
        for (std::size_t number = 0; number < census.counts.size(); ++number) {
            all += census.counts[number];
            of_cases += number > 0 ? census.counts[number] : 0;
        }
    }
    const std::vector<CaseShare> shares = case_shares(family, censuses);
    if (!options.json.empty())
        write_file(options.json, json_of(options, family, found, shares, device)
                                         .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                                     "\n");
    fmt::print("{}{} of {} {} are of a case ({} {})\n", census_table(shares, found.size() > 1), of_cases, all,
               masks == inputs.size() ? "texels"
               : masks == 0           ? "pixels"
                                      : "texels and pixels",
               found.size(), found.size() == 1 ? "census" : "censuses; mean and deviation are over them");
    return options.atlas.empty() ? 0 : write_page(page, family, shares, found.size(), common, replay);
}

} // namespace

void add_census(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand("census", "count how often each case of a technique occurs");
    auto options = std::make_shared<CensusCommand>();
    verb->add_option("INPUT", options->inputs,
                     "masks (.png, .txt) and scenes (glTF, OBJ, PLY); default: the demo scene")
        ->check(not_empty());
    verb->add_option("--technique", options->technique, "whose cases")
        ->check(CLI::IsMember(numbered_techniques()))
        ->capture_default_str();
    verb->add_option("--outside", options->outside, "what lies beyond a mask: clamp, lit or shadow")
        ->check(CLI::IsMember({"clamp", "lit", "shadow"}))
        ->capture_default_str();
    add_view_options(*verb, options->view);
    verb->add_option("--shadow-map", options->shadow_maps,
                     "texels on a side of the shadow map; several, parted by commas, are taken in turn")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    verb->add_option("--lights", options->lights,
                     "directional lights that spread over the sky, taken in turn, instead of the view's one")
        ->check(CLI::Range(1u, 10000u))
        ->excludes("--light-direction")
        ->excludes("--light-position");
    verb->add_option("--json", options->json, "JSON file to write")->check(not_empty());
    verb->add_option("--atlas", options->atlas, "folder for an atlas that shows these shares at every case")
        ->check(not_empty());
    verb->footer("  gnomon census --technique smsr --shadow-map 256,512,1024,2048 --lights 16\n"
                 "  gnomon census mask.png --json shares.json");
    verb->callback([options, verb, &app, &common, &exit_code] {
        for (const char* name :
             {"--lights", "--shadow-map", "--camera-position", "--camera-direction", "--fov", "--near",
              "--far", "--light-direction", "--light-position", "--size", "--bias", "--receiver"})
            if (options->of_views.empty() && verb->count(name) > 0) options->of_views = name;
        exit_code = run(*options, common, replay_options(app));
    });
}

} // namespace gnomon::cli
