#include "casegen/check.h"
#include "casegen/fuzz/campaign.h"
#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/journal.h"
#include "cli/commands.h"
#include "cli/fuzz_report.h"
#include "cli/interrupt.h"
#include "cli/parse.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <memory>

namespace gnomon::cli {
namespace {

struct FuzzCommand {
    std::string pattern, seed = "1", shard = "1/1", format = "text", samples;
    double seconds = 60;
    unsigned jobs = 0;
    bool restart = false, until_found = false;
    std::filesystem::path regressions = GNOMON_SOURCE_DIR "/fixtures/regressions", journal;
};

/// "2/8": the second of eight. Counted from 0 in `shard`.
void parse_shard(const std::string& text, fuzz::CampaignOptions& options) {
    unsigned long long number = 0, count = 0;
    char rest = 0;
    if (text.find_first_not_of("0123456789/") != text.npos ||
        std::sscanf(text.c_str(), "%llu/%llu%c", &number, &count, &rest) != 2 || number < 1 ||
        number > count || count > 1000000)
        throw Error("--shard {}: not I/N with I from 1 to N, as 2/8 for the second of eight", text);
    options.shard = number - 1;
    options.shards = count;
}

int run(const FuzzCommand& options, const Common& common, bool limited, const std::string& replay) {
    std::vector<const Case*> cases;
    for (const Case* c : fuzz::find_subjects(options.pattern))
        if (c->fails.empty()) cases.push_back(c); // those that must fail need no proof
    if (cases.empty())
        throw Error("every kernel that \"{}\" names must fail its check: there is nothing to be found",
                    options.pattern);
    fuzz::CampaignOptions campaign;
    campaign.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    campaign.worst = GNOMON_SOURCE_DIR "/fixtures/worst";
    campaign.regressions = options.regressions;
    if (!options.samples.empty()) campaign.samples = parse_count(options.samples, "--samples");
    campaign.seconds = options.seconds;
    campaign.seed = parse_seed(options.seed).value_or(1);
    campaign.jobs = options.jobs;
    campaign.until_found = options.until_found;
    campaign.device = common.device;
    if (!limited) campaign.device.time_limit = 5;
    parse_shard(options.shard, campaign);
    require_kernels(common.kernels);
    campaign.sources = glsl::frozen(kernel_sources(common.kernels));
    campaign.key = fuzz::campaign_key(cases, campaign);
    campaign.journal = options.journal;
    if (campaign.journal.empty()) {
        const std::filesystem::path folder = cache_directory() / "fuzz";
        std::filesystem::create_directories(folder);
        campaign.journal = folder / (campaign.key + ".journal");
    }
    if (options.restart) fuzz::Journal::discard(campaign.journal);
    // What is wrong with these is told before anything is printed.
    fuzz::load_regressions(campaign.regressions);
    fuzz::make_regressions_folder(campaign.regressions);
    { const fuzz::Journal journal(campaign.journal, campaign.key); }
    campaign.stop = &interrupted_by_signals();
    fuzz::CampaignReport report;
    {
        FuzzProgress progress;
        if (options.format == "text")
            fmt::print("seed {:#x}, {} kernels and chains\n", campaign.seed, cases.size());
        std::fflush(stdout);
        report = fuzz::run_campaign(cases, campaign,
                                    [&](const fuzz::CampaignProgress& now) { progress.show(now); });
    }
    fmt::print("{}",
               options.format == "json" ? fuzz_json(report, campaign) : fuzz_text(report, campaign, replay));
    const bool incomplete = report.interrupted && campaign.samples; // --seconds may end at any time
    return report.findings.empty() && !incomplete ? 0 : 1;
}

} // namespace

void add_fuzz(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "fuzz", "search inputs on which kernels are wrong, crash or hang; shrink and keep what is found");
    auto options = std::make_shared<FuzzCommand>();
    verb->add_option("PATTERN", options->pattern,
                     "part of a name, or a pattern with * and ?, of kernels, of chains over masks "
                     "(chain/…)\nand over scenes (scene/…); several apart by commas (default: all)");
    verb->add_option("--seconds", options->seconds,
                     "begins no new batches after these; Ctrl-C ends it earlier")
        ->check(number_from(0, 1e8))
        ->capture_default_str();
    verb->add_option("--samples", options->samples,
                     "inputs of all kernels together, instead, as 300000 or 1e9: the same ones every time")
        ->check(not_empty())
        ->excludes("--seconds");
    verb->add_option("--seed", options->seed, "another one draws other inputs")->capture_default_str();
    verb->add_option("--jobs", options->jobs, "worker processes (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->add_option("--shard", options->shard, "I/N: the I-th of N parts, which machines may share")
        ->capture_default_str();
    verb->add_flag("--until-found", options->until_found, "end at the first failure");
    verb->add_option("--regressions", options->regressions,
                     "folder that failures are written to, and known ones read from")
        ->check(not_empty())
        ->capture_default_str();
    verb->add_option("--journal", options->journal,
                     "file that keeps what is done until the campaign ends (default: in the cache)")
        ->check(not_empty());
    verb->add_flag("--restart", options->restart, "begin anew where an interrupted campaign would go on");
    verb->add_option("--format", options->format, "text or json")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    verb->footer(
        "Exit code 1 if anything fails, or if --samples are interrupted. Every check begins with what "
        "is found\nhere. An interrupted campaign is resumed by the same command of the same build. A "
        "batch may take 5 s\nunless --time-limit says otherwise.\n\n"
        "  gnomon fuzz                                one minute, all kernels and chains\n"
        "  gnomon fuzz 'smsr/case_*' --samples 1e9    a billion inputs\n"
        "  gnomon fuzz --seconds 28800 --shard 2/8    a night on the second of eight machines");
    verb->callback([options, &app, &common, &exit_code] {
        exit_code = run(*options, common, app.count("--time-limit") > 0, replay_options(app));
    });
}

} // namespace gnomon::cli
