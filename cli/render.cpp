#include "casegen/atlas/frequency.h"
#include "casegen/census.h"
#include "casegen/standalone.h"
#include "casegen/technique.h"
#include "cli/commands.h"
#include "cli/explain.h"
#include "cli/hybrid_report.h"
#include "cli/progress.h"
#include "cli/rendering.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace gnomon::cli {
namespace {

struct RenderCommand {
    std::string scene, technique = "smsr", assembly = "full", variant = to_string(Variant::frequency_order),
                       prune = "on";
    bool explain = false;
    ViewOptions view;
    std::vector<std::string> readings;
    int shadow_map = 1024, frames = 5;
    std::filesystem::path census, report, image, errors;
};

/// Throws Error before minutes of work if one of the outputs cannot be written, or would replace another.
void require_outputs(const RenderCommand& options) {
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

/// The cases of a census, most frequent first.
std::vector<unsigned> cases_of(const Family& family, const std::filesystem::path& path) {
    const atlas::Census census = atlas::read_census(path);
    const auto shares = census.shares.find(family.name);
    if (shares == census.shares.end()) throw Error("'{}' counts no cases of {}", path.string(), family.name);
    std::vector<std::pair<double, unsigned>> met;
    for (const auto& [number, share] : shares->second)
        if (share > 0) met.emplace_back(-share, number);
    std::ranges::sort(met);
    std::vector<unsigned> numbers;
    for (const auto& [share, number] : met) numbers.push_back(number);
    return numbers.empty() ? std::vector<unsigned>{0} : numbers;
}

Assembly assembly_of(const RenderCommand& options, const Family& family, const Counts& counts) {
    const auto variant = std::ranges::find(all_variants(), options.variant,
                                           [](Variant v) { return std::string(to_string(v)); });
    return {*variant,
            options.census.empty() ? cases_by_frequency(family, counts) : cases_of(family, options.census)};
}

std::vector<std::string> variant_names() {
    std::vector<std::string> names;
    for (const Variant variant : all_variants()) names.emplace_back(to_string(variant));
    return names;
}

void run(const RenderCommand& options, const Common& common) {
    const bool is_hybrid = options.technique == "auto" || find_hybrid(options.technique) != nullptr;
    const bool needs_census = options.assembly == "scene" || (options.explain && !is_hybrid);
    if (options.prune == "off" && !is_hybrid)
        throw Error("--prune off needs a hybrid technique; {} is none", options.technique);
    const std::vector<std::string> numbered = numbered_techniques();
    if (needs_census && std::ranges::find(numbered, options.technique) == numbered.end())
        throw Error("--{} needs a technique with numbered cases: {}{}; {} has none",
                    options.explain ? "explain" : "assembly scene", fmt::join(numbered, ", "),
                    options.explain ? ", or a hybrid" : "", options.technique);
    const Readings readings = readings_for(options.technique, options.readings);
    const Scene scene = scene_of(options.scene);
    const auto [camera, light, settings] = view_of(options.view, options.shadow_map, scene,
                                                   is_hybrid ? LightFit::visible_points : LightFit::seen_box);
    require_outputs(options);

    Progress progress("rendering");
    gpu::Device device(common.device);
    Renderer renderer(device, kernel_sources(common.kernels, readings), scene, camera, light, settings);
    const Technique truth_technique = technique_by_name("raytraced");
    progress.show(0, 2);
    const Rendering truth = renderer.render(truth_technique, options.frames);
    progress.show(1, 2);
    Judged judged{options.technique, {}, {}};
    Technique technique = technique_by_name(options.technique);
    technique.prune = options.prune == "on";
    std::optional<Explanation> explanation;
    if (needs_census) {
        const Family& family = technique_family(options.technique);
        const Counts counts = renderer.census(technique);
        const Assembly assembly = assembly_of(options, family, counts);
        if (options.explain)
            explanation = explain(renderer, kernel_sources(common.kernels, readings), family, counts,
                                  assembly, std::max(options.frames, 15));
        if (options.assembly == "scene") technique = technique_of(family, assembly);
    }
    judged.rendering = options.technique == "raytraced" ? truth : renderer.render(technique, options.frames);
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
    report["assembly"] = options.assembly;
    if (options.assembly == "scene") report["left_out_pixels"] = judged.rendering.left_out;
    if (judged.rendering.hybrid) report["hybrid"] = hybrid_json(judged.rendering, technique.prune);
    if (readings != Readings{}) report["readings"] = to_string(readings);
    if (explanation)
        report["explanation"] = explanation_json(technique_family(options.technique), *explanation);
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
    if (judged.rendering.left_out > 0)
        fmt::print("{} pixels of a frame were of a case left out: found again with all cases\n",
                   judged.rendering.left_out);
    if (options.explain && judged.rendering.hybrid)
        fmt::print("\n{}", hybrid_text(judged.rendering, technique.prune));
    if (!explanation) return;
    fmt::print("\n{}", explanation_text(technique_family(options.technique), *explanation));
    if (explanation->differing > 0)
        throw Error("leaving cases out changed {} pixels", explanation->differing);
}

} // namespace

void add_render(CLI::App& app, Common& common) {
    CLI::App* verb =
        app.add_subcommand("render", "render a scene and judge its shadows against ray-traced truth");
    auto options = std::make_shared<RenderCommand>();
    verb->add_option("SCENE", options->scene, "glTF, OBJ or PLY file (default: the demo scene)")
        ->check(not_empty());
    verb->add_option("--technique", options->technique, "how visibility is found")
        ->check(CLI::IsMember(technique_names()))
        ->capture_default_str();
    verb->add_option("--assembly", options->assembly,
                     "which of the technique's cases its kernel holds: all, or those that a census of this "
                     "very view finds")
        ->check(CLI::IsMember({"full", "scene"}))
        ->capture_default_str();
    verb->add_flag("--explain", options->explain,
                   "what leaving cases out is worth here: census, cases, instructions, times; of a hybrid: "
                   "rays, maps, what was left out and why, what auto chose");
    verb->add_option("--prune", options->prune,
                     "off: a hybrid takes every step, whether the frame needs it or not")
        ->check(CLI::IsMember({"on", "off"}))
        ->capture_default_str();
    verb->add_option(
            "--census", options->census,
            "JSON file of gnomon census: with --assembly scene, hold the cases counted there instead")
        ->check(not_empty());
    verb->add_option("--variant", options->variant,
                     "how a view's cases are chosen among: docs/assembly.md says what each is")
        ->check(CLI::IsMember(variant_names()))
        ->capture_default_str();
    add_reading_option(*verb, options->readings);
    add_view_options(*verb, options->view);
    verb->add_option("--shadow-map", options->shadow_map, "texels on a side of the shadow map")
        ->capture_default_str();
    verb->add_option("--frames", options->frames,
                     "frames that times are the median of; one more is discarded")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    verb->add_option("--report", options->report, "JSON file to write")->check(not_empty());
    verb->add_option("--image", options->image, "PNG file to write: the shaded frame")->check(not_empty());
    verb->add_option("--errors", options->errors,
                     "PNG file to write: red lit but truly in shadow, blue shadowed but truly lit")
        ->check(not_empty());
    verb->footer(
        "  gnomon render --technique smsr --image smsr.png --errors wrong.png\n"
        "  gnomon render city.glb --shadow-map 2048 --light-direction=-0.5,-0.65,0.35 --report city.json");
    verb->callback([options, &common] { run(*options, common); });
}

} // namespace gnomon::cli
