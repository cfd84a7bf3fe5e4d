#include "casegen/coverage/measure.h"
#include "casegen/coverage/report.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace gnomon::cli {
namespace {

struct CoverageCommand {
    std::string pattern, format = "text", seed;
    std::optional<std::size_t> samples;
    bool only_fixtures = false, missing = false;
    std::filesystem::path lcov, regressions = GNOMON_SOURCE_DIR "/fixtures/regressions";
    std::optional<double> fail_under;
    unsigned jobs = 0;
};

bool is_enough(const coverage::Share& share, double percent) {
    return share.of == 0 || 100 * static_cast<double>(share.all) >= percent * static_cast<double>(share.of);
}

int run(const CoverageCommand& options, const Common& common) {
    const std::vector<const Case*> cases = find_cases(options.pattern);
    coverage::Options what;
    what.only_fixtures = options.only_fixtures;
    what.check.kernels = common.kernels;
    what.check.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    what.check.worst = GNOMON_SOURCE_DIR "/fixtures/worst";
    what.check.regressions = options.regressions;
    what.check.samples = options.samples;
    what.check.seed = parse_seed(options.seed);
    what.check.device = common.device;
    what.check.jobs = options.jobs;
    if (!options.lcov.empty()) require_writable(options.lcov);
    coverage::Coverage coverage;
    {
        Progress progress("measuring");
        const std::size_t total = samples_asked_for(cases, what.check);
        coverage = coverage::measure(cases, what, [&](std::size_t done) { progress.show(done, total); });
    }
    require_no_validation_messages();
    if (!options.lcov.empty()) write_file(options.lcov, coverage::to_lcov(coverage, common.kernels));
    if (options.format == "json") {
        fmt::print("{}\n", coverage::to_json(coverage));
    } else {
        fmt::print("{}", coverage::to_text(coverage, options.missing));
        fmt::print(
            "\nStages of whole pipelines (kernels/pipeline, kernels/hybrid) do not run alone and are not "
            "measured.\n");
    }
    const bool measured = std::ranges::all_of(
        coverage.kernels, [](const coverage::KernelRun& kernel) { return kernel.trouble.empty(); });
    const coverage::Totals sum = coverage::totals(coverage);
    const bool enough = !options.fail_under || (is_enough(sum.lines, *options.fail_under) &&
                                                is_enough(sum.branches, *options.fail_under));
    return measured && enough ? 0 : 1;
}

} // namespace

void add_coverage(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand("coverage", "which lines and branches of kernels their inputs reach");
    auto options = std::make_shared<CoverageCommand>();
    verb->add_option("PATTERN", options->pattern, pattern_help);
    verb->add_option("--samples", options->samples,
                     "inputs per kernel, fixtures included (default: as check)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40));
    verb->add_flag("--only-fixtures", options->only_fixtures, "no random samples");
    verb->add_option("--seed", options->seed, "of all kernels (default: each its own, the hash of its name)");
    verb->add_option("--lcov", options->lcov, "write LCOV's tracefile, for genhtml")->check(not_empty());
    verb->add_option("--format", options->format, "text or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    verb->add_flag("--missing", options->missing, "list what was not reached, line by line");
    verb->add_option("--fail-under", options->fail_under,
                     "exit with 1 if fewer per cent of the lines, or of the branches, were reached")
        ->check(number_from(0, 100));
    verb->add_option("--jobs", options->jobs,
                     "worker threads, each with its own device (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->add_option("--regressions", options->regressions, "folder of what gnomon fuzz found")
        ->check(is_folder())
        ->capture_default_str();
    verb->footer("Fixtures are what every check begins with: regressions, worst inputs, pins, hostile and "
                 "stiff values.\n"
                 "Exit code 1 also if a kernel cannot be measured, or gives other results with counters than "
                 "without.\n\n"
                 "  gnomon coverage --missing               every kernel, and what was not reached\n"
                 "  gnomon coverage rsmss/case_12 --only-fixtures --missing\n"
                 "  gnomon coverage --lcov out/kernels.info && genhtml --branch-coverage -o out/lcov "
                 "out/kernels.info");
    verb->callback([options, &common, &exit_code] { exit_code = run(*options, common); });
}

} // namespace gnomon::cli
