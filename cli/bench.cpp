#include "casegen/measure/bench.h"

#include "casegen/check.h"
#include "casegen/measure/report.h"
#include "casegen/measure/tables.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"

#include <fmt/format.h>

#include <memory>

namespace gnomon::cli {
namespace {

struct Options {
    std::string pattern, seed;
    std::filesystem::path out;
    measure::BenchOptions bench;
    std::vector<std::string> trigonometry{"portable"};
    bool no_time = false, classes = false;
};

void run(const Options& options, const Common& common) {
    std::vector<Trigonometry> modes;
    for (const std::string& mode : options.trigonometry) modes.push_back(parse_trigonometry(mode));
    require_kernels(common.kernels);
    const std::vector<measure::Group> groups =
        measure::group(measure::find_variants(options.pattern), modes, common.kernels);
    measure::BenchOptions bench_options = options.bench;
    bench_options.kernels = common.kernels;
    bench_options.device = common.device;
    bench_options.seed = parse_seed(options.seed);
    if (options.no_time) bench_options.rounds = 0;
    if (!options.out.empty()) measure::require_report_folder(options.out);
    measure::Bench made;
    {
        Progress progress("measuring");
        made = measure::bench(groups, bench_options,
                              [&](std::size_t done) { progress.show(done, groups.size()); });
    }
    require_no_validation_messages();
    if (!options.out.empty()) measure::write_report(options.out, made);
    fmt::print("{}", measure::to_text(made, options.classes));
    if (!options.out.empty())
        fmt::print("Pictures and tables are in {}\n", (options.out / "report.html").string());
}

} // namespace

void add_bench(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb =
        app.add_subcommand("bench", "measure how wrong kernels are and how long they take, side by side");
    auto options = std::make_shared<Options>();
    verb->add_option(
        "PATTERN", options->pattern,
        "a quantity (integral/a0), part of a kernel's name, or a pattern with * and ? (default: all)");
    verb->add_option("--samples", options->bench.samples, "ordinary inputs per quantity")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 18))
        ->capture_default_str();
    verb->add_option("--repeats", options->bench.repeats, "inputs near every locus at every distance")
        ->check(CLI::Range(std::size_t{0}, std::size_t{64}))
        ->capture_default_str();
    verb->add_option("--seed", options->seed, "of the inputs (default: each quantity its own, as check)");
    verb->add_option("--rounds", options->bench.rounds, "how often each variant is timed")
        ->check(CLI::Range(1u, 1000u))
        ->capture_default_str();
    verb->add_flag("--no-time", options->no_time, "errors only")->excludes("--rounds");
    verb->add_flag("--classes", options->classes, "print tables by class of input too");
    verb->add_option("--out", options->out,
                     "folder for report.html, its pictures alone (.svg), and bench.json")
        ->check(not_empty());
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
                 "  gnomon bench smsr --no-time                           how wrong a family's kernels are");
    add_bench_hybrid(*verb, common, exit_code);
    verb->callback([options, verb, &common] {
        if (verb->get_subcommands().empty()) run(*options, common);
    });
}

} // namespace gnomon::cli
