#include "casegen/atlas/atlas.h"

#include "cli/atlas_page.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"

#include <fmt/format.h>

#include <memory>

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

struct AtlasCommand {
    fs::path folder;
    std::vector<fs::path> censuses;
    std::string seed;
    std::optional<std::size_t> samples;
    unsigned jobs = 0;
    bool coverage = false;
};

coverage::Coverage measure_coverage(const CheckOptions& check) {
    coverage::Options what;
    what.check = check;
    what.check.regressions = GNOMON_SOURCE_DIR "/fixtures/regressions";
    const std::vector<const Case*> cases = find_cases("");
    Progress progress("measuring");
    const std::size_t total = samples_asked_for(cases, check);
    return coverage::measure(cases, what, [&](std::size_t done) { progress.show(done, total); });
}

int run(const AtlasCommand& options, const Common& common, const std::string& replay) {
    atlas::Options what = atlas_options(common);
    for (const fs::path& census : options.censuses) what.censuses.push_back(atlas::read_census(census));
    what.check.samples = options.samples;
    what.check.seed = parse_seed(options.seed);
    what.check.jobs = options.jobs;
    const fs::path path = require_atlas_folder(options.folder, common);
    if (options.coverage) what.coverage = measure_coverage(what.check);
    atlas::Atlas atlas;
    {
        Progress progress("checking");
        const std::size_t total = samples_asked_for(find_cases(""), what.check);
        atlas = atlas::make_atlas(catalogue(), what, [&](std::size_t done) { progress.show(done, total); });
    }
    require_no_validation_messages();
    write_atlas(path, atlas, common, replay);

    fmt::print("{}", atlas_summary(atlas, path));
    return atlas.passes() ? 0 : 1;
}

} // namespace

void add_atlas(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "atlas", "write one HTML page about every case: mask, condition, formula, values, error, cost");
    auto options = std::make_shared<AtlasCommand>();
    verb->add_option("OUT_DIR", options->folder, "folder for index.html, made if it is missing")
        ->required()
        ->check(not_empty());
    verb->add_option("--samples", options->samples,
                     "inputs per kernel; pins and hostile values are always all run")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40))
        ->capture_default_str();
    verb->add_option("--seed", options->seed, "of all kernels (default: each its own, the hash of its name)");
    verb->add_option("--census", options->censuses,
                     "JSON file of shares counted elsewhere, as gnomon census writes it; may be repeated");
    verb->add_flag("--coverage", options->coverage,
                   "show which lines and branches of each case were reached, as gnomon coverage counts them");
    verb->add_option("--jobs", options->jobs,
                     "worker threads, each with its own device (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->footer(
        "The page needs no network and no other file. Exit code 1 if a kernel fails: its entry says so.\n\n"
        "  gnomon atlas out/atlas");
    verb->callback(
        [options, &app, &common, &exit_code] { exit_code = run(*options, common, replay_options(app)); });
}

} // namespace gnomon::cli
