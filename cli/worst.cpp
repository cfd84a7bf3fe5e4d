#include "casegen/catalogue.h"
#include "casegen/check.h"
#include "casegen/worst/file.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace gnomon::cli {
namespace {

struct WorstCommand {
    std::string kernel, seed;
    std::filesystem::path folder = GNOMON_SOURCE_DIR "/fixtures/worst";
    worst::SearchOptions search;
};

std::string describe_error(const Case& c, const std::vector<worst::Row>& rows) {
    if (rows.empty()) return "nothing";
    return fmt::format("{}{} (allowed: {})", format_error(rows.front().error),
                       rows.front().passes ? "" : ", which fails", to_string(c.tolerance));
}

int run(const WorstCommand& options, const Common& common, const std::string& replay) {
    const Case& c = find_case(options.kernel);
    if (!c.fails.empty()) throw Error("{} must fail, nothing is to be searched: {}", c.name, c.fails);
    if (std::isnan(options.search.seconds)) throw Error("--seconds nan: not a number of seconds");
    const std::filesystem::path path = worst::file_of(options.folder, c);
    require_kernels(common.kernels);
    worst::require_worst_file(path);
    worst::SearchOptions search = options.search;
    search.kernels = common.kernels;
    search.device = common.device;
    search.seed = parse_seed(options.seed);
    search.worst = path;
    search.pins = GNOMON_SOURCE_DIR "/fixtures/pins/" + c.name + ".csv";
    search.stop = &interrupted_by_signals();
    worst::Found found;
    {
        Progress progress("searching");
        found = worst::search(c, search, [&](double seconds, std::size_t evaluations, double) {
            if (search.evaluations > 0)
                progress.show(evaluations, search.evaluations);
            else
                progress.show(static_cast<std::size_t>(seconds), static_cast<std::size_t>(search.seconds));
        });
    }
    require_no_validation_messages();
    worst::write_worst(path, c, found);

    fmt::print("{}: {} evaluations, seed {:#018x}{}\n", c.name, found.evaluations, found.seed,
               *search.stop ? "; interrupted" : "");
    fmt::print("  before: {}\n  now:    {}\n", describe_error(c, found.before),
               describe_error(c, found.rows));
    if (found.rows.empty()) {
        fmt::print("  no input on which it is wrong at all; {} is as it was\n", path.string());
        return 0;
    }
    const worst::Row& row = found.rows.front();
    Finding finding;
    finding.input = row.words;
    if (row.mask) finding.mask = *row.mask;
    fmt::print("  {}\n  {} rows are in {}\n", replay_command(c, finding, replay), worst::merged(found).size(),
               path.string());
    return c.fails.empty() && !row.passes ? 1 : 0;
}

} // namespace

void add_worst(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "worst", "search the inputs on which a kernel is most wrong; every check begins with them");
    auto options = std::make_shared<WorstCommand>();
    verb->add_option("KERNEL", options->kernel, "as gnomon list prints it: integral/mix/radiance")
        ->required();
    verb->add_option("--seconds", options->search.seconds,
                     "how long to search; Ctrl-C ends it and keeps what is found")
        ->check(number_from(0, 1e7))
        ->capture_default_str();
    verb->add_option("--evaluations", options->search.evaluations,
                     "how many inputs to try instead: the same inputs every time")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40))
        ->excludes("--seconds");
    verb->add_option("--seed", options->seed, "of the search (default: as check)");
    verb->add_option("--jobs", options->search.jobs, "threads that judge (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->add_option("--folder", options->folder, "where <KERNEL>.csv is read and written")
        ->check(not_empty())
        ->capture_default_str();
    verb->footer(
        "The file keeps the 32 worst of different octaves, those it held before among them. Exit code 1 if\n"
        "the worst is more than the kernel's tolerance allows.\n\n"
        "  gnomon worst integral/mix/radiance --seconds 600\n"
        "  gnomon worst integral/sinc/a0 --evaluations 100000 --seed 7");
    verb->callback(
        [options, &app, &common, &exit_code] { exit_code = run(*options, common, replay_options(app)); });
}

} // namespace gnomon::cli
