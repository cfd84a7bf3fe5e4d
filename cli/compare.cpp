#include "casegen/catalogue.h"
#include "casegen/check.h"
#include "casegen/versus/versus.h"
#include "cli/commands.h"
#include "cli/compare_report.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

namespace gnomon::cli {
namespace {

struct CompareCommand {
    std::string a, b, pattern, kernel, seed, format = "text", axes, at, size = "512x512";
    std::optional<std::size_t> samples, rounds;
    double seconds = 3, least_effect = 3;
    bool no_time = false;
    std::filesystem::path image, regressions = GNOMON_SOURCE_DIR "/fixtures/regressions";
};

/// Everything that stands still in the picture, as eval takes it.
CsvInput parse_at(const Case& c, const std::string& at) {
    const Csv csv = parse_csv(fmt::format("{}\n{}\n", fmt::join(columns(c), ","), at), "--at");
    return read_inputs(c, csv).front();
}

void prepare_picture(const CompareCommand& options, const versus::Plan& plan,
                     versus::ExaminerOptions& examiner) {
    if (plan.pairs.size() != 1)
        throw Error(
            "--image shows one kernel, and {} are of other text; name it, as \"gnomon compare A B {}\"",
            plan.pairs.size(), plan.pairs.empty() ? std::string("smsr/case_09") : plan.pairs.front().a->name);
    const Case& c = *plan.pairs.front().a;
    if (options.axes.empty())
        versus::telling_axes(c, {}); // refuses what has none
    else
        examiner.axes = versus::parse_axes(c, options.axes);
    const auto [width, height] = parse_size(options.size, "--size");
    if (width < 1 || height < 1 || width > 2048 || height > 1024)
        throw Error("--size {}: from 1x1 to 2048x1024 is possible", options.size);
    examiner.size = {width, height};
    if (!options.at.empty()) examiner.at = parse_at(c, options.at);
    require_writable(options.image);
}

int run(const CompareCommand& options, const Common& common, bool limited, bool kernels_given,
        const std::string& device) {
    require_kernels(common.kernels);
    versus::Side a = versus::side_of(options.a, common.kernels, options.kernel);
    versus::Side b = versus::side_of(options.b, common.kernels, options.kernel);
    if (!options.kernel.empty() && !a.kernel && !b.kernel)
        throw Error("--kernel {}: neither {} nor {} is a file; a PATTERN behind them chooses kernels",
                    options.kernel, options.a, options.b);
    for (versus::Side* side : {&a, &b}) {
        const std::string kernels = fmt::format(" --kernels {}", in_quotes(common.kernels.string()));
        if (!kernels_given && side->options.starts_with(kernels)) side->options.erase(0, kernels.size());
        side->options += device;
    }
    const versus::Plan plan = versus::make_plan(a, b, options.pattern);

    versus::VersusOptions versus_options;
    versus::ExaminerOptions& examiner = versus_options.examiner;
    examiner.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    examiner.worst = GNOMON_SOURCE_DIR "/fixtures/worst";
    examiner.regressions = options.regressions;
    examiner.samples = options.samples;
    examiner.seed = parse_seed(options.seed);
    examiner.device = common.device;
    if (!limited) examiner.device.time_limit = 5;
    examiner.timing.seconds = options.seconds;
    examiner.timing.rounds = options.rounds;
    examiner.timing.seed = examiner.seed.value_or(1);
    examiner.timing.pace.least_effect = options.least_effect / 100;
    versus_options.times = !options.no_time;
    versus_options.picture = !options.image.empty();
    if (versus_options.picture) prepare_picture(options, plan, examiner);
    if (!versus_options.picture && !(options.axes.empty() && options.at.empty()))
        throw Error("--axes and --at are about a picture: --image FILE.png says where it goes");

    versus::VersusReport report;
    {
        Progress progress("comparing");
        report = versus::run_plan(a, b, plan, versus_options,
                                  [&](std::size_t done) { progress.show(done, plan.pairs.size()); });
    }
    for (const versus::Comparison& one : report.comparisons)
        if (one.drawn) write_file(options.image, one.picture.png);
    const CompareHead head{a.label, b.label, options.image, versus_options.times};
    fmt::print("{}", options.format == "json" ? compare_json(head, plan, report) + '\n'
                                              : compare_text(head, plan, report));
    if (report.comparisons.empty() && !options.image.empty() && options.format != "json")
        fmt::print("image none: no kernel's code differs\n");
    if (std::ranges::any_of(report.comparisons, versus::is_worse)) return 1;
    return plan.only_a.empty() ? 0 : 1; // B has lost a kernel
}

} // namespace

void add_compare(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "compare", "set two kernels, folders or revisions against each other: output, error and time; exit "
                   "code 1 if B is wrong on a sample where A is right");
    auto options = std::make_shared<CompareCommand>();
    const char* side = "a folder of kernels, a kernel's file, a kernel's name, or a git revision";
    verb->add_option("A", options->a, side)->required()->check(not_empty());
    verb->add_option("B", options->b, "the same; A is what B is held against")
        ->required()
        ->check(not_empty());
    verb->add_option("PATTERN", options->pattern,
                     "of folders and revisions: which kernels, several patterns apart by commas (default: "
                     "all that\ncompile to other code)");
    verb->add_option("--kernel", options->kernel,
                     "the kernel that a file stands for, if its function's name does not say so")
        ->check(not_empty());
    verb->add_option("--samples", options->samples, "inputs per kernel (default: as check)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 21));
    verb->add_option("--seed", options->seed, "of the inputs (default: as check)");
    verb->add_flag("--no-time", options->no_time, "output and error only");
    CLI::Option* seconds = verb->add_option("--seconds", options->seconds,
                                            "of timing, per kernel; it ends earlier where that decides")
                               ->check(number_from(0, 1e6))
                               ->capture_default_str();
    verb->add_option("--rounds", options->rounds, "exactly so many rounds of A, B and A again instead")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}))
        ->excludes(seconds);
    verb->add_option("--least-effect", options->least_effect,
                     "in per cent of the time: what is less is no difference")
        ->check(number_from(0.1, 10))
        ->capture_default_str();
    verb->add_option("--image", options->image, "PNG of where one kernel differs, over two of its inputs")
        ->check(not_empty());
    verb->add_option(
            "--axes", options->axes,
            "of the picture: p.x,p.y, or with ranges p.x=0:0.5,p.y=0:1 (default: the two that tell most)")
        ->check(not_empty());
    verb->add_option("--at", options->at,
                     "the other inputs in the picture: all columns, as eval takes them (default: where the "
                     "difference is worst)")
        ->check(not_empty());
    verb->add_option("--size", options->size, "of the picture")->capture_default_str();
    verb->add_option("--regressions", options->regressions, "folder of what gnomon fuzz found: run first")
        ->check(is_folder())
        ->capture_default_str();
    verb->add_option("--format", options->format, "text or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    verb->footer("A revision is looked up in the git repository that holds --kernels; git:NAME or NAME: says "
                 "that it is one.\nWhat SAME, FASTER, SLOWER and UNCERTAIN mean: docs/compare.md.\n\n"
                 "  gnomon compare HEAD kernels               what have I changed?\n"
                 "  gnomon compare HEAD~3 HEAD 'smsr/*' --no-time\n"
                 "  gnomon compare integral/sinc/a0 integral/exact_theta/a0\n"
                 "  gnomon compare smsr/case_09 my_case.glsl --image where.png --axes p.x,p.y");
    verb->callback([options, &app, &common, &exit_code] {
        const std::string device =
            app.count("--device") > 0 ? fmt::format(" --device {}", in_quotes(common.device.name)) : "";
        exit_code = run(*options, common, app.count("--time-limit") > 0, app.count("--kernels") > 0, device);
    });
}

} // namespace gnomon::cli
