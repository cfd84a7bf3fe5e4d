#include "casegen/watch/session.h"
#include "cli/commands.h"
#include "cli/parse.h"
#include "cli/view.h"
#include "cli/watch_report.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <memory>

#include <fcntl.h>
#include <unistd.h>

namespace gnomon::cli {
namespace {

struct WatchCommand {
    std::vector<std::string> patterns;
    std::string format = "text", seed;
    std::optional<std::size_t> samples, edits;
    unsigned jobs = 0;
    bool poll = false, no_times = false;
    std::filesystem::path regressions = GNOMON_SOURCE_DIR "/fixtures/regressions";
};

/// A signal ends the session at its next wait: through a pipe, so that none comes too early for that.
int stop_pipe = -1;
extern "C" void stop_watching(int) {
    const char byte = 0;
    [[maybe_unused]] const ssize_t written = ::write(stop_pipe, &byte, 1); // a full pipe says it already
}

int stop_by_signals() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        throw Error("no pipe for Ctrl-C to be heard through");
    stop_pipe = ends[1];
    std::signal(SIGINT, stop_watching);
    std::signal(SIGTERM, stop_watching);
    return ends[0];
}

int run(const WatchCommand& options, const Common& common, bool limited, const std::string& replay) {
    const std::vector<const Case*> cases = find_cases(fmt::format("{}", fmt::join(options.patterns, ",")));
    watch::SessionOptions session;
    session.check.kernels = common.kernels;
    session.check.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    session.check.worst = GNOMON_SOURCE_DIR "/fixtures/worst";
    session.check.regressions = options.regressions;
    session.check.samples = options.samples;
    session.check.seed = parse_seed(options.seed);
    session.check.device = common.device;
    if (!limited) session.check.device.time_limit = 2;
    session.check.jobs = options.jobs;
    session.replay = replay;
    session.times = !options.no_times;
    session.poll = options.poll;
    session.edits = options.edits;
    session.stop = stop_by_signals();
    const std::string folder = common.kernels.string();
    const bool colours = ::isatty(STDOUT_FILENO) == 1;
    const std::size_t bad = watch::run_session(cases, session, [&](const watch::Event& event) {
        if (options.format == "json")
            fmt::print("{}\n", watch_json(event, folder));
        else
            fmt::print("{}", watch_text(event, folder, colours));
        std::fflush(stdout);
    });
    if (options.format == "json")
        fmt::print("{{\"event\":\"end\",\"bad\":{}}}\n", bad);
    else if (bad > 0)
        fmt::print("ended; {} of {} kernels are not known to be good\n", bad, cases.size());
    else
        fmt::print("ended; all {} kernels are good\n", cases.size());
    return bad > 0 ? 1 : 0;
}

} // namespace

void add_watch(CLI::App& app, Common& common, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "watch", "stay, and check kernels again on every save: verdict, what moved, time before and after");
    auto options = std::make_shared<WatchCommand>();
    verb->add_option("PATTERN", options->patterns, pattern_help);
    verb->add_option("--samples", options->samples, "inputs per kernel (default: as check)")
        ->check(CLI::Range(std::size_t{1}, watch::most_samples));
    verb->add_option("--seed", options->seed, "of all kernels (default: each its own, as check)");
    verb->add_option("--format", options->format, "text, or json: one object a line for each event")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    verb->add_option("--jobs", options->jobs, "worker processes (default: one per core)")
        ->check(CLI::Range(0u, 256u));
    verb->add_option("--edits", options->edits, "end after so many edits (default: at Ctrl-C)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40));
    verb->add_flag("--no-times", options->no_times, "do not time what changed");
    verb->add_flag("--poll", options->poll,
                   "look at all files every 0.1 s: for folders that other machines write to");
    verb->add_option("--regressions", options->regressions,
                     "folder of what gnomon fuzz found: run before all else")
        ->check(is_folder())
        ->capture_default_str();
    verb->footer(
        "Exit code 1 if a kernel is not good at the end. A dispatch may take 2 s unless --time-limit "
        "says otherwise.\n\n"
        "  gnomon watch smsr rsmss               two families, while their files are edited\n"
        "  gnomon watch smsr/case_09 --format json");
    verb->callback([options, &app, &common, &exit_code] {
        exit_code = run(*options, common, app.count("--time-limit") > 0, replay_options(app));
    });
}

} // namespace gnomon::cli
