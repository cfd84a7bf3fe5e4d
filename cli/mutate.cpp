#include "casegen/check.h"
#include "casegen/fuzz/regression.h"
#include "casegen/mutate/campaign.h"
#include "casegen/standalone.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/mutate_report.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace gnomon::cli {
namespace {

struct MutateCommand {
    std::string pattern, format = "text", seed, operators, mutant;
    std::optional<std::size_t> samples, limit;
    unsigned jobs = 0;
    bool show = false;
    std::filesystem::path json, equivalents = GNOMON_SOURCE_DIR "/fixtures/mutants/equivalent.json",
                                regressions = GNOMON_SOURCE_DIR "/fixtures/regressions";
};

std::vector<mutate::Operator> operators_of(const std::string& list) {
    if (list.empty()) return mutate::all_operators();
    std::vector<mutate::Operator> operators;
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        operators.push_back(mutate::parse_operator(list.substr(at, end - at)));
        at = end + 1;
    }
    return operators;
}

int run(const MutateCommand& options, const Common& common, bool limited, const std::string& replay) {
    const std::vector<const Case*> cases = find_cases(options.pattern);
    require_kernels(common.kernels);
    if (!options.json.empty()) require_writable(options.json);
    mutate::CampaignOptions campaign;
    campaign.examiner.sources = glsl::frozen(kernel_sources(common.kernels));
    campaign.examiner.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    campaign.examiner.worst = GNOMON_SOURCE_DIR "/fixtures/worst";
    for (const auto& [name, all] : fuzz::load_regressions(options.regressions))
        for (const fuzz::Regression& regression : all)
            campaign.examiner.regressions[name].push_back(regression.input);
    campaign.examiner.samples = options.samples;
    campaign.examiner.seed = parse_seed(options.seed);
    campaign.examiner.device = common.device;
    if (!limited) campaign.examiner.device.time_limit = 5;
    campaign.operators = operators_of(options.operators);
    campaign.equivalents = mutate::load_equivalents(options.equivalents);
    campaign.limit = options.limit;
    campaign.only = options.mutant;
    campaign.jobs = options.jobs;
    const glsl::Sources& sources = campaign.examiner.sources;
    if (options.show) {
        for (const mutate::Mutant& mutant : mutate::mutants_of(cases, sources, campaign.operators))
            if (mutant.id == options.mutant) {
                fmt::print("{}", mutant.text);
                return 0;
            }
        throw Error("none of these kernels has a mutant {}", options.mutant);
    }
    campaign.stop = &interrupted_by_signals();
    mutate::CampaignReport report;
    {
        Progress progress("mutating");
        report = mutate::run_campaign(cases, campaign,
                                      [&](std::size_t done, std::size_t of) { progress.show(done, of); });
    }
    if (!options.json.empty()) write_file(options.json, mutate_json(report));
    if (options.format == "json")
        fmt::print("{}", mutate_json(report));
    else if (options.format == "junit")
        fmt::print("{}", mutate_junit(report, sources));
    else if (!options.mutant.empty())
        fmt::print("{}", mutant_text(report.mutants.front(), sources));
    else
        fmt::print("{}", mutate_text(report, sources, replay));
    return report.good() ? 0 : 1;
}

} // namespace

void add_mutate(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb =
        app.add_subcommand("mutate", "change kernels a little, and require that their checks turn red");
    auto options = std::make_shared<MutateCommand>();
    verb->add_option("PATTERN", options->pattern, pattern_help);
    verb->add_option(
        "--operators", options->operators,
        "only these, apart by commas: constant, comparison, arithmetic, bits, sign, logic, condition, "
        "component, call, arguments, statement, result, stale");
    verb->add_option("--limit", options->limit, "only so many mutants, always the same")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40));
    CLI::Option* mutant = verb->add_option("--mutant", options->mutant,
                                           "only the one of this id: what it is, and "
                                           "what becomes of it");
    verb->add_flag("--show", options->show, "print its whole file instead")->needs(mutant);
    verb->add_option("--samples", options->samples, "random samples per kernel, as check's; at most 262144")
        ->check(CLI::Range(std::size_t{1}, mutate::most_samples));
    verb->add_option("--seed", options->seed, "of all kernels' samples, as check's");
    verb->add_option("--jobs", options->jobs, "worker processes (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->add_option("--equivalents", options->equivalents,
                     "list of mutants that no check can notice, with reasons")
        ->check(not_empty())
        ->capture_default_str();
    verb->add_option("--regressions", options->regressions, "folder of what gnomon fuzz found, as check's")
        ->check(is_folder())
        ->capture_default_str();
    verb->add_option("--json", options->json, "also write the report to this file")->check(not_empty());
    verb->add_option("--format", options->format, "text, json or junit")
        ->check(CLI::IsMember({"text", "json", "junit"}))
        ->capture_default_str();
    verb->footer(
        "Exit code 1 if a mutant survives that is not listed as equivalent, if one that is listed does not, "
        "or if it\nis gone. A dispatch may take 5 s unless --time-limit says otherwise. Ctrl-C reports what "
        "is done.\n\n"
        "  gnomon mutate smsr,rsmss,rbsm,adjacency\n"
        "  gnomon mutate smsr/case_09 --operators comparison,constant\n"
        "  gnomon mutate smsr/case_09 --mutant 0123456789 --show");
    verb->callback([options, &app, &common, &exit_code] {
        exit_code = run(*options, common, app.count("--time-limit") > 0, replay_options(app));
    });
}

} // namespace gnomon::cli
