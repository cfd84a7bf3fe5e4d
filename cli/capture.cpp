#include "casegen/capture.h"
#include "casegen/catalogue.h"
#include "casegen/csv.h"
#include "casegen/readings.h"
#include "casegen/standalone.h"
#include "casegen/technique.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <map>
#include <memory>

namespace gnomon::cli {
namespace {

using Pixels = std::vector<std::uint32_t>;

struct CaptureCommand {
    std::string scene, technique, case_name, kernel;
    std::vector<std::string> pixels, readings;
    ViewOptions view;
    int shadow_map = 1024;
    std::size_t most = 0; ///< 0: all
    bool verify = false;
    std::filesystem::path out;
};

const Family& family_of(const Case& c) {
    for (const Family& family : catalogue())
        for (const Case& known : family.cases)
            if (&known == &c) return family;
    throw std::logic_error("a case of no family");
}

/// What the options ask for, before a frame is drawn.
struct Request {
    const HybridTechnique* hybrid = nullptr; ///< null: the family is the technique
    const Family* family = nullptr;
    const Case* numbered = nullptr; ///< of --case
    const Case* kernel = nullptr;   ///< null: the numbered case that a pixel is of; a hybrid's own detector
};

bool is_technique(const std::string& name) {
    const std::vector<std::string> names = visibility_techniques();
    return std::ranges::find(names, name) != names.end();
}

Request request_of(const CaptureCommand& options) {
    Request request;
    if (!options.case_name.empty()) {
        request.numbered = request.kernel = &find_case(options.case_name);
        if (request.numbered->number == 0)
            throw Error("--case {}: not a numbered case of a technique; --kernel captures other kernels",
                        options.case_name);
    }
    if (!options.kernel.empty() && options.kernel != "case") request.kernel = &find_case(options.kernel);
    std::string technique = options.technique;
    for (const Case* c : {static_cast<const Case*>(request.kernel), request.numbered})
        if (technique.empty() && c && is_technique(technique_name(family_of(*c))))
            technique = technique_name(family_of(*c));
    if (technique.empty() && request.kernel && request.kernel->name.starts_with("certainty/"))
        technique = request.kernel->name.substr(request.kernel->name.find('/') + 1);
    if (technique.empty()) technique = "smsr";
    if (options.pixels.empty() && options.case_name.empty() && options.kernel.empty())
        throw Error("capture needs --pixel X,Y, or --case FAMILY/CASE, or --kernel KERNEL");
    if ((request.hybrid = find_hybrid(technique))) {
        if (request.numbered || options.kernel == "case") throw Error("{} has no numbered cases", technique);
        return request;
    }
    request.family = &technique_family(technique);
    if (request.numbered && &family_of(*request.numbered) != request.family)
        throw Error("--case {}: a case of {}, not of {}", options.case_name,
                    technique_name(family_of(*request.numbered)), technique);
    if (options.kernel == "case" && !find_kernel(*request.family, "number"))
        throw Error("--kernel case: {} has no numbered cases", technique);
    if (options.kernel.empty() && !request.kernel)
        request.kernel = find_kernel(*request.family, "visibility");
    if (!options.pixels.empty() && !options.case_name.empty())
        throw Error("--pixel and --case: give one; --kernel case captures the case that a pixel is of");
    if (options.pixels.empty() && options.kernel == "case")
        throw Error("--kernel case needs --pixel X,Y; --case FAMILY/CASE captures one case wherever it is");
    return request;
}

/// Throws Error if the technique does not call it.
void require_called(const std::vector<const Case*>& called, const Case& c, const std::string& technique) {
    if (std::ranges::find(called, &c) != called.end()) return;
    std::vector<std::string> names;
    for (const Case* each : called) names.push_back(each->name);
    throw Error("{} is not called by {}; what it calls can be captured: {}", c.name, technique,
                fmt::join(names, ", "));
}

const ChainLink& link_of(const std::vector<ChainLink>& chain, const Case& c, const std::string& technique) {
    std::vector<const Case*> called;
    for (const ChainLink& link : chain) called.push_back(link.kernel);
    require_called(called, c, technique);
    return *std::ranges::find(chain, &c, &ChainLink::kernel);
}

std::uint32_t parse_pixel(const std::string& text, const ViewSettings& settings) {
    int x = 0, y = 0, end = 0;
    if (std::sscanf(text.c_str(), "%7d,%7d%n", &x, &y, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size())
        throw Error("--pixel {}: X,Y is needed, two whole numbers", text);
    if (x < 0 || y < 0 || x >= settings.width || y >= settings.height)
        throw Error("--pixel {}: the image is {} x {}; 0,0 is its upper left pixel", text, settings.width,
                    settings.height);
    return static_cast<std::uint32_t>(y * settings.width + x);
}

/// The pixels of --pixel, each once. Throws Error at one that no kernel is asked about. A hybrid's maps may
/// reach farther than the frame's.
Pixels chosen_pixels(const CaptureCommand& options, Renderer& renderer, bool within_map) {
    Pixels chosen;
    const Pixels asked = within_map ? asked_pixels(renderer) : Pixels{};
    for (const std::string& text : options.pixels) {
        const std::uint32_t pixel = parse_pixel(text, renderer.settings());
        if (renderer.surfaces().covered[pixel] == 0)
            throw Error("--pixel {}: no surface is seen there", text);
        if (renderer.surfaces().facing[pixel] == 0)
            throw Error("--pixel {}: the surface there faces away from the light: it is dark without asking "
                        "a kernel",
                        text);
        if (within_map && !std::ranges::binary_search(asked, pixel))
            throw Error("--pixel {}: the shadow map does not cover it: it is lit without asking a kernel",
                        text);
        if (std::ranges::find(chosen, pixel) == chosen.end()) chosen.push_back(pixel);
    }
    return chosen;
}

/// The case that these pixels are of.
const Case& case_of(Renderer& renderer, const Request& request, const Pixels& pixels) {
    const Pixels numbers = case_numbers(renderer, technique_of(*request.family), pixels);
    if (std::ranges::count(numbers, numbers.front()) != std::ssize(numbers))
        throw Error("--kernel case: the pixels are of different cases ({}); capture them one by one",
                    fmt::join(numbers, ", "));
    for (const Case* c : numbered_cases(*request.family))
        if (c->number == numbers.front()) return *c;
    throw Error("--kernel case: the pixel is of no case of {}: it keeps its shadow test",
                technique_name(*request.family));
}

Pixels pixels_of_case(Renderer& renderer, const Request& request, const Pixels& asked) {
    const Pixels numbers = case_numbers(renderer, technique_of(*request.family), asked);
    Pixels pixels;
    std::map<std::uint32_t, std::size_t> met;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (numbers[i] == request.numbered->number)
            pixels.push_back(asked[i]);
        else if (numbers[i] != 0)
            ++met[numbers[i]];
    }
    if (!pixels.empty()) return pixels;
    std::vector<std::uint32_t> others;
    for (const auto& [number, count] : met) others.push_back(number);
    throw Error("no pixel of this view is of {}; it has pixels of the cases {}", request.numbered->name,
                others.empty() ? "(none)" : fmt::format("{}", fmt::join(others, ", ")));
}

/// Reads the file's text back and makes the same calls alone. Says what differs; 1 if anything does.
int verify(gpu::Device& device, const glsl::Sources& sources, const Captured& captured,
           const std::string& text) {
    const Case& c = *captured.kernel;
    const Csv csv = parse_csv(text, "captured");
    const std::vector<CsvInput> inputs = read_inputs(c, csv);
    Records records(c);
    for (const CsvInput& input : inputs) records.add(input.words, &input.mask);
    const Outputs outputs = evaluate(device, sources, c, records);
    if (const std::string complaint = outputs.complaint(); !complaint.empty()) {
        fmt::print("{}: {}; gnomon check {} tells more\n", c.name, complaint, c.name);
        return 1;
    }
    std::vector<std::uint32_t> wanted;
    for (const CapturedCall& call : captured.calls)
        wanted.insert(wanted.end(), call.result.begin(), call.result.end());
    const std::vector<std::size_t> rows = differing_rows(c, wanted, outputs.words);
    if (rows.empty()) {
        fmt::print("verified: alone, all {} calls give the bits of the pipeline\n", inputs.size());
        return 0;
    }
    fmt::print("verified: alone, {} of {} calls give other bits than in the pipeline; the first is row {}\n",
               rows.size(), inputs.size(), rows.front() + 1);
    return 1;
}

/// Of a case whose pixels were chosen by it, and of a whole visibility kernel: its answer is the pixel's.
std::size_t unlike_visibility(const Captured& captured) {
    return static_cast<std::size_t>(std::ranges::count_if(captured.calls, [](const CapturedCall& call) {
        return call.result.front() != std::bit_cast<std::uint32_t>(call.visibility);
    }));
}

constexpr std::size_t most_windows = 50000; // of 1.4 kB each, as text

/// Calls to write, and what is said of them.
struct Calls {
    Captured captured;
    std::string what;
    std::size_t unlike = 0; ///< pixels whose visibility is not what the kernel answers
};

/// What the stages of a hybrid call.
Calls hybrid_calls(const CaptureCommand& options, const Request& request, const glsl::Sources& sources,
                   Renderer& renderer, const Scene& scene) {
    const std::string& name = request.hybrid->name;
    const Technique technique{.kind = Technique::Kind::hybrid, .name = name};
    const std::vector<const Case*> called = kernels_of(renderer.stages(technique));
    const auto is_detector = [](const Case& c) { return c.name.starts_with("certainty/"); };
    const auto detector = std::ranges::find_if(called, [&](const Case* c) { return is_detector(*c); });
    if (called.empty()) throw Error("{} calls no kernel", name);
    if (request.kernel) require_called(called, *request.kernel, name);
    if (!request.kernel && detector == called.end())
        throw Error("{} has no kernel that says all of a pixel: give --kernel as well", name);
    const Case& c = request.kernel ? *request.kernel : **detector;
    const Pixels pixels = chosen_pixels(options, renderer, false);
    const bool windows = c.reference.takes_mask;
    Calls calls{capture_frame_calls(renderer, sources, technique, {&c}, pixels,
                                    windows && options.most == 0 ? most_windows : options.most)
                    .front(),
                {}};
    const Captured& captured = calls.captured;
    if (captured.calls.empty())
        throw Error("{} calls {} {}", name, c.name,
                    pixels.empty() ? "nowhere in this view"
                                   : fmt::format("at none of the {} pixels", pixels.size()));
    if (windows && options.most == 0 && captured.all > most_windows)
        throw Error("{} at {} pixels, each with its window of the map; --most {} or less is possible", c.name,
                    captured.all, most_windows);
    std::vector<std::string> stages;
    for (const CapturedCall& call : captured.calls)
        if (stages.empty() || stages.back() != captured.stages[call.stage])
            stages.push_back(captured.stages[call.stage]);
    calls.what = fmt::format("{} as {} calls it in {}: {} of {} calls, in {}", c.name, name, scene.name,
                             captured.calls.size(), captured.all, fmt::join(stages, ", "));
    if (is_detector(c)) // 0 or 1 where it is certain
        calls.unlike =
            static_cast<std::size_t>(std::ranges::count_if(captured.calls, [](const CapturedCall& call) {
                return call.result.front() < 2 && static_cast<float>(call.result.front()) != call.visibility;
            }));
    return calls;
}

/// What a technique's kernels call at its pixels.
Calls technique_calls(const CaptureCommand& options, const Request& request, const glsl::Sources& sources,
                      Renderer& renderer, const Scene& scene, const std::vector<ChainLink>& chain) {
    const std::string name = technique_name(*request.family);
    const Technique technique = technique_of(*request.family);
    Pixels pixels = options.pixels.empty() ? asked_pixels(renderer) : chosen_pixels(options, renderer, true);
    const Case& c = request.kernel ? *request.kernel : case_of(renderer, request, pixels);
    const ChainLink& link = link_of(chain, c, name);
    if (request.numbered) pixels = pixels_of_case(renderer, request, pixels);
    const std::size_t looked_at = pixels.size();
    if (&c != request.numbered) pixels = calling_pixels(renderer, sources, technique, link, pixels);
    if (pixels.empty()) throw Error("{} calls {} at none of the {} pixels", name, c.name, looked_at);
    const std::size_t all = pixels.size();
    pixels = spread(pixels, options.most);
    if (c.reference.takes_mask && pixels.size() > most_windows)
        throw Error("{} at {} pixels, each with its window of the map; --most {} or less is possible", c.name,
                    pixels.size(), most_windows);
    Calls calls{capture_calls(renderer, sources, technique, link.question, {&c}, pixels).front(), {}};
    calls.what = fmt::format("{} as {} calls it in {}: {} calls, at {} of {} pixels that do", c.name, name,
                             scene.name, calls.captured.calls.size(), pixels.size(), all);
    if (&c == find_kernel(*request.family, "visibility") || &c == request.numbered || !request.kernel)
        calls.unlike = unlike_visibility(calls.captured);
    return calls;
}

/// `common_options` are what a command that replays this must say besides (replay_options).
void run(const CaptureCommand& options, const Common& common, const std::string& common_options,
         int& exit_code) {
    const Request request = request_of(options);
    const std::string name = request.hybrid ? request.hybrid->name : technique_name(*request.family);
    const Readings readings = readings_for(name, options.readings);
    const glsl::Sources sources = kernel_sources(common.kernels, readings);
    std::vector<ChainLink> chain;
    if (!request.hybrid) chain = chain_of(sources, technique_of(*request.family));
    if (!request.hybrid && request.kernel) link_of(chain, *request.kernel, name);
    const Scene scene = scene_of(options.scene);
    const auto [camera, light, settings] = view_of(options.view, options.shadow_map, scene);
    for (const std::string& pixel : options.pixels) parse_pixel(pixel, settings);
    require_writable(options.out);

    gpu::Device device(common.device);
    Renderer renderer(device, sources, scene, camera, light, settings);
    const Calls calls = request.hybrid ? hybrid_calls(options, request, sources, renderer, scene)
                                       : technique_calls(options, request, sources, renderer, scene, chain);
    const Captured& captured = calls.captured;
    const Case& c = *captured.kernel;
    require_no_validation_messages();

    std::string replay = fmt::format("gnomon eval {} --in {} --expect captured{}", c.name,
                                     in_quotes(options.out.string()), common_options);
    for (const std::string& reading : options.readings) replay += " --reading " + reading;
    const std::string text = captured_csv(captured, settings.width, calls.what + "\n" + replay);
    write_file(options.out, text);
    fmt::print("{}\n{}\n", calls.what, replay);
    if (!captured.unlike_frame.empty()) {
        fmt::print(
            "at {} pixels the frame had another visibility than while calls were recorded: some kernel "
            "is no function of its parameters\n",
            captured.unlike_frame.size());
        exit_code = 1;
    }
    if (calls.unlike > 0) {
        fmt::print("at {} pixels the visibility is not what {} answers\n", calls.unlike, c.name);
        exit_code = 1;
    }
    if (options.verify && verify(device, sources, captured, text) != 0) exit_code = 1;
    require_no_validation_messages();
}

/// Those of one map and its kernels, and the hybrids.
std::vector<std::string> capturable_techniques() {
    std::vector<std::string> names = visibility_techniques();
    for (const HybridTechnique& hybrid : hybrid_techniques()) names.push_back(hybrid.name);
    return names;
}

} // namespace

void add_capture(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand("capture", "write the exact kernel inputs met in a frame, for eval");
    auto options = std::make_shared<CaptureCommand>();
    verb->add_option("SCENE", options->scene, "glTF, OBJ or PLY file (default: the demo scene)")
        ->check(not_empty());
    verb->add_option("--technique", options->technique,
                     "whose kernels (default: that of the case or kernel, else smsr)")
        ->check(CLI::IsMember(capturable_techniques()));
    verb->add_option("--pixel", options->pixels,
                     "X,Y of a pixel, 0,0 is the upper left; as often as one likes")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb->add_option("--case", options->case_name,
                     "instead of pixels: all that are of this case (rsmss/case_17), with its own inputs")
        ->check(not_empty());
    verb->add_option(
            "--kernel", options->kernel,
            "whose inputs: any kernel that the technique calls, or `case`, the one that the pixel is "
            "of (default: the technique's visibility; with --case, the case; of a hybrid, what says all of a "
            "pixel)")
        ->check(not_empty());
    verb->add_option("--most", options->most,
                     "at most so many pixels (of a hybrid: calls), evenly spread over all (default: all)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 30));
    verb->add_flag("--verify", options->verify,
                   "make the same calls alone at once; exit code 1 if any gives other bits");
    add_reading_option(*verb, options->readings);
    add_view_options(*verb, options->view);
    verb->add_option("--shadow-map", options->shadow_map, "texels on a side of the shadow map")
        ->capture_default_str();
    verb->add_option("--out", options->out,
                     "CSV file to write: the kernel's columns, then pixel_x, pixel_y, "
                     "captured (what it answered), visibility (the pixel's)")
        ->required()
        ->check(not_empty());
    verb->footer("  gnomon capture --technique rsmss --pixel 512,400 --out pixel.csv --verify\n"
                 "  gnomon capture --case rsmss/case_17 --most 100 --out case_17.csv\n"
                 "  gnomon eval rsmss/case_17 --in case_17.csv --expect captured");
    verb->callback(
        [options, &app, &common, &exit_code] { run(*options, common, replay_options(app), exit_code); });
}

} // namespace gnomon::cli
