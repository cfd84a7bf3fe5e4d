// What fuzzing is worth: how many evaluations a second it makes of the visibility cases, and how soon it
// finds a bug planted in any one place of them.
//
//     build/bench/check_fuzz speed [RUNS]        smsr/case_* and rsmss/case_* in turns, medians (default 5
//     runs) build/bench/check_fuzz bugs [PATTERN]      every mutation of every case's file that PATTERN names
//                                                (default: all 43), one campaign
//                                                each
//
// `bugs` changes one thing in a copy of the kernels (mutate/operators.h: each constant, comparison, operator,
// condition, arm, component, call, argument, statement and result in turn) and runs `gnomon fuzz CASE
// --until-found --seconds 10` as a process of its own: what is measured is what an author waits, compilation,
// shrinking and all. A change that no input can show (the same code, or another only where the tolerance
// leaves a step to either side) is found by nobody: such are listed as they are, to be read.
#include "casegen/catalogue.h"
#include "casegen/mutate/operators.h"
#include "casegen/pattern.h"
#include "runtime/clock.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

extern char** environ;

namespace {

namespace fs = std::filesystem;
using gnomon::Error;

constexpr double seconds_allowed = 10;

struct Ran {
    int exit_code = 0;
    double seconds = 0, cpu_seconds = 0; ///< on the wall; of the process and its workers
    nlohmann::json report;               ///< what it printed; null if that is no JSON
};

Ran fuzz(std::vector<std::string> arguments, const fs::path& folder) {
    const fs::path out = folder / "out";
    arguments.insert(arguments.begin(), {GNOMON_PROGRAM, "fuzz"});
    arguments.insert(arguments.end(),
                     {"--format", "json", "--restart", "--regressions", (folder / "found").string(),
                      "--journal", (folder / "journal").string()});
    std::vector<char*> argv;
    for (std::string& text : arguments) argv.push_back(text.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0644);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const double start = gnomon::seconds_now();
    pid_t child = 0;
    const int failed = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw Error("{} cannot be started: error {}", argv[0], failed);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    Ran ran;
    ran.seconds = gnomon::seconds_now() - start;
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    ran.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
    ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    ran.report = nlohmann::json::parse(gnomon::read_file(out), nullptr, false);
    if (ran.report.is_discarded()) throw Error("gnomon fuzz {}: exit code {}", arguments[2], ran.exit_code);
    return ran;
}

/// A folder that is gone with the object.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / fmt::format("gnomon-check-fuzz-{}", getpid())) {
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string processor() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

void print_machine() { fmt::print("{} threads of {}\n", std::thread::hardware_concurrency(), processor()); }

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

// ---------------------------------------------------------------------------------------------------------

void measure_speed(int runs) {
    struct Measured {
        std::string pattern;
        std::vector<double> on_the_wall{}, of_a_core{}; ///< millions a second
    };
    std::vector<Measured> all{{"smsr/case_*"}, {"rsmss/case_*"}};
    const Folder folder;
    for (int i = 0; i < runs; ++i)
        for (Measured& each : all) {
            const Ran ran = fuzz({each.pattern, "--seconds", "6"}, folder.path());
            if (ran.exit_code != 0) throw Error("gnomon fuzz {} found something", each.pattern);
            const double millions = ran.report.at("evaluations").get<double>() * 1e-6;
            each.on_the_wall.push_back(millions / ran.seconds);
            each.of_a_core.push_back(millions / ran.cpu_seconds);
        }
    print_machine();
    fmt::print("{} runs of 6 s; generation, kernel, reference and comparison included\n", runs);
    fmt::print("{:<14}{:>16}{:>20}{:>22}{:>20}\n", "kernels", "M/s, whole run", "min to max",
               "M per s of one core", "on 4 such cores");
    for (Measured& each : all) {
        const auto [least, most] = std::ranges::minmax(each.on_the_wall);
        const double core = median(each.of_a_core);
        fmt::print("{:<14}{:>16.1f}{:>20}{:>22.2f}{:>20.1f}\n", each.pattern, median(each.on_the_wall),
                   fmt::format("{:.1f} to {:.1f}", least, most), core, 4 * core);
    }
}

// ---------------------------------------------------------------------------------------------------------

/// "1 call" or the size of the mask that a regression holds.
std::string shrunk_to(const fs::path& file) {
    const nlohmann::json input = nlohmann::json::parse(gnomon::read_file(file)).at("input");
    if (!input.contains("mask")) return "1 call";
    const std::string mask = input.at("mask");
    const auto rows = std::ranges::count(mask, '/') + 1;
    return fmt::format("{} x {} texels", (static_cast<long>(mask.size()) + 1) / rows - 1, rows);
}

struct Tally {
    std::size_t planted = 0, found = 0, late = 0, large = 0;
    std::vector<double> seconds;
    std::vector<std::string> missed;
};

void plant_one(const gnomon::Case& c, const gnomon::mutate::Mutation& mutation, const std::string& text,
               const fs::path& file, const Folder& folder, Tally& tally) {
    const std::string changed = gnomon::mutate::mutated(text, mutation);
    gnomon::write_file(file, changed);
    fs::remove_all(folder.path() / "found");
    const Ran ran = fuzz({c.name, "--until-found", "--seconds", fmt::format("{}", seconds_allowed), "--jobs",
                          "1", "--kernels", (folder.path() / "kernels").string()},
                         folder.path());
    const std::string what =
        fmt::format("{}:{}:{} {}: {} -> {}", c.name, mutation.line, mutation.column,
                    gnomon::mutate::to_string(mutation.by),
                    text.substr(mutation.begin, mutation.end - mutation.begin), mutation.after);
    const nlohmann::json& findings = ran.report.at("findings");
    if (!findings.empty() && findings.at(0).at("failure") == "compile error") return;
    ++tally.planted;
    if (findings.empty()) {
        tally.missed.push_back(what);
        fmt::print("{:>6}  {:<16}  {}\n", "-", "not found", what);
        return;
    }
    ++tally.found;
    tally.seconds.push_back(ran.seconds);
    tally.late += ran.seconds > seconds_allowed ? 1 : 0;
    const std::string path = findings.at(0).at("file").get<std::string>();
    const std::string size = path.empty() ? "no input" : shrunk_to(path);
    tally.large += size == "1 call" ? 0 : 1;
    fmt::print("{:>5.2f}s  {:<16}  {}\n", ran.seconds, size, what);
    std::fflush(stdout);
}

void plant_bugs(const std::vector<const gnomon::Case*>& cases) {
    const Folder folder;
    const fs::path kernels = folder.path() / "kernels";
    fs::copy(GNOMON_SOURCE_DIR "/kernels", kernels, fs::copy_options::recursive);
    print_machine();
    Tally tally;
    for (const gnomon::Case* c : cases) {
        const fs::path file = kernels / (c->name + ".glsl");
        const std::string text = gnomon::read_file(file);
        for (const gnomon::mutate::Mutation& mutation : gnomon::mutate::mutations(text))
            plant_one(*c, mutation, text, file, folder, tally);
        gnomon::write_file(file, text);
    }
    std::ranges::sort(tally.seconds);
    fmt::print("\n{} bugs planted in {} cases, {} found", tally.planted, cases.size(), tally.found);
    if (!tally.seconds.empty())
        fmt::print(": median {:.2f} s, slowest {:.2f} s, {} after {:g} s; {} shrunk to more than one call",
                   tally.seconds[tally.seconds.size() / 2], tally.seconds.back(), tally.late, seconds_allowed,
                   tally.large);
    fmt::print("\n");
    for (const std::string& missed : tally.missed) fmt::print("not found: {}\n", missed);
}

std::vector<const gnomon::Case*> numbered(const std::string& pattern) {
    std::vector<const gnomon::Case*> found;
    for (const std::string family : {"smsr", "rsmss"})
        for (const gnomon::Case* c : gnomon::numbered_cases(gnomon::technique_family(family)))
            if (pattern.empty() || gnomon::matches(c->name, pattern)) found.push_back(c);
    if (found.empty()) throw Error("no case of smsr or rsmss is called \"{}\"", pattern);
    return found;
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    try {
        if (!arguments.empty() && arguments.size() <= 2 && arguments[0] == "speed") {
            int runs = 5;
            if (arguments.size() == 2) {
                const std::string& text = arguments[1];
                const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), runs);
                if (error != std::errc{} || end != text.data() + text.size() || runs < 1)
                    throw Error("speed takes one number: how many runs (default 5)");
            }
            measure_speed(runs);
        } else if (!arguments.empty() && arguments.size() <= 2 && arguments[0] == "bugs") {
            plant_bugs(numbered(arguments.size() == 2 ? arguments[1] : ""));
        } else {
            throw Error("call it with: speed [RUNS], or: bugs [PATTERN]");
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "check_fuzz: {}\n", error.what());
        return 2;
    }
    return 0;
}
