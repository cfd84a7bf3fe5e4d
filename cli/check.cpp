#include "casegen/check.h"
#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/replay.h"
#include "casegen/pattern.h"
#include "casegen/worker_device.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/gpu/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace gnomon::cli {
namespace {

struct CheckCommand {
    std::string pattern, format = "text", seed;
    std::optional<std::size_t> samples;
    unsigned jobs = 0;
    std::filesystem::path regressions = GNOMON_SOURCE_DIR "/fixtures/regressions";
};

int run(const CheckCommand& options, const Common& common, const std::string& replay) {
    // A driver takes longer to load than all else for one kernel: it begins before the catalogue is made.
    std::optional<WorkerDevice> first(common.device);
    const auto is_chain = [](const Case* c) { return fuzz::find_chain(*c) != nullptr; };
    for (const std::string& part : split_patterns(options.pattern))
        if (const std::vector<const Case*> named = fuzz::find_subjects(part);
            std::ranges::all_of(named, is_chain) &&
            fuzz::with_regressions(named, options.regressions).empty())
            throw Error("{} has no regressions on file, and nothing else of a chain is checked; gnomon fuzz "
                        "'{}' examines it",
                        named.front()->name, part);
    const std::vector<const Case*> chains =
        fuzz::with_regressions(fuzz::find_chains(options.pattern), options.regressions);
    std::vector<const Case*> cases = fuzz::find_subjects(options.pattern);
    std::erase_if(cases, is_chain);
    CheckOptions check_options;
    check_options.kernels = common.kernels;
    check_options.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    check_options.worst = GNOMON_SOURCE_DIR "/fixtures/worst";
    check_options.regressions = options.regressions;
    check_options.samples = options.samples;
    check_options.seed = parse_seed(options.seed);
    check_options.device = common.device;
    check_options.jobs = options.jobs;
    std::vector<CheckReport> reports;
    {
        Progress progress("checking");
        const std::size_t total = samples_asked_for(cases, check_options);
        if (!cases.empty())
            reports = check(
                cases, check_options, [&](std::size_t done) { progress.show(done, total); }, &*first);
        for (CheckReport& report : fuzz::replay(chains, check_options, *first))
            reports.push_back(std::move(report));
        first.reset(); // its farewell too is heard by the validation layer
    }
    require_no_validation_messages();
    if (options.format == "json")
        fmt::print("{}\n", check_json(reports, replay));
    else if (options.format == "junit")
        fmt::print("{}\n", check_junit(reports, replay));
    else
        fmt::print("{}", check_text(reports, replay));
    for (const CheckReport& report : reports)
        if (!is_good(report.verdict)) return 1;
    return 0;
}

} // namespace

void require_no_validation_messages() {
    if (const std::vector<std::string> messages = gpu::take_validation_messages(); !messages.empty())
        throw Error("Vulkan's validation layer complains ({} messages): {}", messages.size(),
                    messages.front());
}

void add_check(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb =
        app.add_subcommand("check", "run kernels against their references; exit code 1 if one fails");
    auto options = std::make_shared<CheckCommand>();
    verb->add_option("PATTERN", options->pattern, pattern_help);
    verb->add_option("--samples", options->samples,
                     "inputs per kernel (default: 65536, or 8192 where the reference is multiprecision); "
                     "pins, hostile "
                     "and stiff values are always all run")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40));
    verb->add_option("--seed", options->seed, "of all kernels (default: each its own, the hash of its name)");
    verb->add_option("--format", options->format, "text, json or junit")
        ->check(CLI::IsMember({"text", "json", "junit"}))
        ->capture_default_str();
    verb->add_option("--jobs", options->jobs,
                     "worker threads, each with its own device (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->add_option("--regressions", options->regressions,
                     "folder of what gnomon fuzz found: run before all else")
        ->check(is_folder())
        ->capture_default_str();
    verb->footer("Regressions (those of chains too, which nothing else here runs), worst ones, pins and "
                 "hostile values (NaN, infinities, denormals, ranges' "
                 "ends) come first, then random "
                 "samples.\n\n"
                 "  gnomon check                          every kernel\n"
                 "  gnomon check 'smsr/case_*'            a family's cases\n"
                 "  gnomon check smsr/case_09 --samples 10000000 --seed 7\n"
                 "  gnomon check --format junit > check.xml");
    verb->callback(
        [options, &app, &common, &exit_code] { exit_code = run(*options, common, replay_options(app)); });
}

} // namespace gnomon::cli
