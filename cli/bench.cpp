#include "cli/bench_frames.h"
#include "cli/bench_report.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"

#include "casegen/check.h"
#include "casegen/measure/extras.h"
#include "casegen/measure/report.h"
#include "casegen/measure/tables.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

namespace gnomon::cli {
namespace {

struct BenchCommand {
    std::string pattern, seed, format = "text";
    std::filesystem::path out, save, against, mutation, coverage;
    measure::BenchOptions bench;
    std::vector<std::string> trigonometry{"portable"}, scenes;
    bool no_time = false, classes = false;
    const CLI::App* verb = nullptr;

    bool is_given(const char* option) const { return verb->get_option(option)->count() > 0; }
    /// A page alone, or a folder.
    bool out_is_page() const { return out.extension() == ".html"; }
};

/// What all kernels and techniques are measured with: the baseline's own inputs, if there is one, or what is
/// compared would be chance. Throws Error if the options say otherwise.
measure::BenchOptions bench_options(const BenchCommand& options, const Common& common,
                                    const std::optional<measure::Baseline>& baseline) {
    measure::BenchOptions result = options.bench;
    result.kernels = common.kernels;
    result.device = common.device;
    result.seed = parse_seed(options.seed);
    if (baseline) {
        for (const char* option : {"--samples", "--repeats", "--seed"})
            if (options.is_given(option))
                throw Error("{} is the baseline's where one is measured --against", option);
        result.samples = baseline->samples;
        result.repeats = baseline->repeats;
        result.seed = baseline->seed;
    }
    if (options.no_time) result.rounds = 0;
    return result;
}

/// The kernels whose times moved, once more, with their groups put together as before.
measure::Bench measured_again(const std::vector<measure::Group>& groups, const std::set<std::string>& names,
                              const measure::BenchOptions& options) {
    std::vector<measure::Group> again;
    for (const measure::Group& group : groups)
        if (std::ranges::any_of(group.variants, [&](const measure::Variant& variant) {
                return names.contains(full_name(variant));
            }))
            again.push_back(group);
    Progress progress("measuring again what seems to have moved");
    return measure::bench(again, options, [&](std::size_t done) { progress.show(done, again.size()); });
}

/// What moved; times only if a second measurement says the same.
measure::Moved moved_since(const measure::Baseline& baseline, const measure::Report& report,
                           const std::vector<measure::Group>& groups, const std::vector<FrameWork>& work,
                           const measure::BenchOptions& options, bool whole) {
    const measure::Moved first =
        measure::moved(baseline, measure::baseline_of(report.bench, report.scenes), whole);
    std::set<std::string> names;
    for (const measure::Move& move : first.moves)
        if (move.time) names.insert(move.name);
    if (names.empty()) return first;
    const measure::Bench again = measured_again(groups, names, options);
    std::vector<FrameWork> scenes;
    for (const FrameWork& one : work)
        if (std::ranges::any_of(
                names, [&](const std::string& name) { return name.starts_with(one.view.scene + ": "); }))
            scenes.push_back(one);
    const std::vector<measure::SceneResult> frames = measure_frames(scenes, options);
    return measure::confirmed(first, measure::moved(baseline, measure::baseline_of(again, frames), false));
}

/// Throws Error now if what is to be written could not be later, or would replace another.
void require_outputs(const BenchCommand& options) {
    if (options.out_is_page())
        require_writable(options.out);
    else if (!options.out.empty())
        measure::require_report_folder(options.out);
    if (options.save.empty()) return;
    require_writable(options.save);
    if (!options.out.empty() &&
        std::filesystem::weakly_canonical(options.save) == std::filesystem::weakly_canonical(options.out))
        throw Error("--out and --save both name '{}'; each needs a file of its own", options.save.string());
}

int run(const BenchCommand& options, const Common& common) {
    std::vector<Trigonometry> modes;
    for (const std::string& mode : options.trigonometry) modes.push_back(parse_trigonometry(mode));
    require_kernels(common.kernels);
    std::optional<measure::Baseline> baseline;
    if (!options.against.empty()) baseline = measure::read_baseline(options.against);
    measure::Report report;
    if (!options.mutation.empty())
        report.mutation = measure::mutation_section(read_file(options.mutation), options.mutation.string());
    if (!options.coverage.empty())
        report.coverage = measure::coverage_section(read_file(options.coverage), options.coverage.string());
    const measure::BenchOptions bench = bench_options(options, common, baseline);
    const std::vector<measure::Group> groups =
        measure::group(measure::find_variants(options.pattern), modes, common.kernels);

    // Techniques belong to what is kept or compared as a whole.
    const bool whole = options.pattern.empty();
    std::vector<std::string> scenes = options.scenes;
    if (scenes == std::vector<std::string>{"none"})
        scenes.clear();
    else if (scenes.empty() && whole && baseline)
        for (const measure::SceneRecord& scene : baseline->scenes) scenes.push_back(scene.scene);
    else if (scenes.empty() && whole && (!options.out.empty() || !options.save.empty()))
        scenes = default_scenes();
    const std::vector<FrameWork> work = frame_work(scenes, baseline);
    require_outputs(options);

    {
        Progress progress("measuring kernels");
        report.bench =
            measure::bench(groups, bench, [&](std::size_t done) { progress.show(done, groups.size()); });
    }
    report.scenes = measure_frames(work, bench);
    if (baseline) {
        report.baseline = options.against.string();
        report.moved =
            moved_since(*baseline, report, groups, work, bench, whole && !options.is_given("--trigonometry"));
    }
    require_no_validation_messages();

    if (options.out_is_page())
        write_file(options.out, measure::bench_page(report));
    else if (!options.out.empty())
        measure::write_report(options.out, report);
    if (!options.save.empty())
        write_file(options.save, measure::to_json(measure::baseline_of(report.bench, report.scenes)));
    if (options.format == "json")
        fmt::print("{}", measure::bench_json(report, options.classes));
    else if (options.format == "junit")
        fmt::print("{}\n", bench_junit(report));
    else
        fmt::print("{}", bench_text(report, options.classes));
    if (options.format == "text" && !options.out.empty())
        fmt::print("Pictures and tables are in {}\n",
                   (options.out_is_page() ? options.out : options.out / "report.html").string());
    if (options.format == "text" && !options.save.empty())
        fmt::print("The baseline is in {}\n", options.save.string());
    return is_bad(report) ? 1 : 0;
}

} // namespace

void add_bench(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "bench", "measure how wrong kernels and techniques are and how long they take, side by side");
    auto options = std::make_shared<BenchCommand>();
    options->verb = verb;
    verb->add_option("PATTERN", options->pattern,
                     "a quantity (integral/a0), part of a kernel's name, or a pattern with * and ?; several "
                     "apart by commas\n(default: all)");
    verb->add_option("--samples", options->bench.samples, "ordinary inputs per quantity")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 18))
        ->capture_default_str();
    verb->add_option("--repeats", options->bench.repeats, "inputs near every locus at every distance")
        ->check(CLI::Range(std::size_t{0}, std::size_t{64}))
        ->capture_default_str();
    verb->add_option("--seed", options->seed, "of the inputs (default: each quantity its own, as check)");
    verb->add_option("--rounds", options->bench.rounds, "how often each variant and technique is timed")
        ->check(CLI::Range(1u, 1000u))
        ->capture_default_str();
    verb->add_flag("--no-time", options->no_time, "errors and instruction counts only")->excludes("--rounds");
    verb->add_flag("--classes", options->classes, "print tables by class of input too");
    verb->add_option("--scenes", options->scenes,
                     "scenes to measure every technique on, parted by commas: demo, or glTF, OBJ or PLY "
                     "files; none (default: without PATTERN, the baseline's, or for --out and --save demo "
                     "and a ramp of thin strips)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(not_empty());
    verb->add_option("--out", options->out,
                     "FILE.html, one page with everything; or a folder for report.html, its pictures alone "
                     "(.svg), and bench.json")
        ->check(not_empty());
    verb->add_option("--save", options->save, "JSON file to write: a baseline for --against")
        ->check(not_empty());
    verb->add_option("--against", options->against,
                     "a baseline: print only what moved beyond noise; exit code 1 if for the worse")
        ->check(not_empty());
    verb->add_option("--format", options->format, "text, json or junit")
        ->check(CLI::IsMember({"text", "json", "junit"}))
        ->capture_default_str();
    for (const auto& [name, path] :
         {std::pair{"mutation", &options->mutation}, std::pair{"coverage", &options->coverage}})
        verb->add_option(fmt::format("--{}", name), *path,
                         fmt::format("JSON file of gnomon {}, to show on the page",
                                     path == &options->mutation ? "mutate" : "coverage"))
            ->check(not_empty())
            ->needs("--out");
    verb->add_option(
            "--trigonometry", options->trigonometry,
            "whose sine, cosine and exponential kernels call: portable, built-in, coarse; several, parted by "
            "commas, stand side by side")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    verb->add_option("--jobs", options->bench.jobs, "threads for truths (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->footer("  gnomon bench integral/radiance --out out/radiance     the variants of one quantity, with "
                 "pictures\n"
                 "  gnomon bench --out bench.html                         everything on one page\n"
                 "  gnomon bench smsr --no-time                           how wrong a family's kernels are\n"
                 "  gnomon bench --against fixtures/baseline.json         what moved");
    add_bench_hybrid(*verb, common, exit_code);
    verb->callback([options, verb, &common, &exit_code] {
        if (verb->get_subcommands().empty()) exit_code = run(*options, common);
    });
}

} // namespace gnomon::cli
