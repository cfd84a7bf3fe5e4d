// How long an author waits: `gnomon check` as a whole process, from its start to its end, in the
// situations that matter. The situations take turns, so that a machine that slows down slows all of them
// alike; medians.
//
//     build/bench/check_latency [RUNS]         default 15
#include "casegen/catalogue.h"
#include "casegen/pattern.h"
#include "casegen/standalone.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

extern char** environ;

namespace {

namespace fs = std::filesystem;
using gnomon::Error;

/// Milliseconds from spawning `gnomon ARGUMENTS` to its end. Throws Error unless it exits with 0.
double run(const std::vector<std::string>& arguments, const fs::path& cache) {
    std::vector<std::string> texts{GNOMON_PROGRAM};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& text : texts) argv.push_back(text.data());
    argv.push_back(nullptr);
    setenv("GNOMON_CACHE", cache.c_str(), 1);

    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int failed = posix_spawn(&child, argv[0], &quiet, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&quiet);
    if (failed != 0) throw Error("{} cannot be started: error {}", argv[0], failed);
    int status = 0;
    waitpid(child, &status, 0);
    const auto end = std::chrono::steady_clock::now();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error("gnomon {} failed", arguments.front());
    return std::chrono::duration<double, std::milli>(end - start).count();
}

std::string processor() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

/// The kernels of the fewest SPIR-V words, by name, as one PATTERN.
std::string smallest_kernels(std::size_t count) {
    const gnomon::glsl::Sources sources = gnomon::kernel_sources(GNOMON_SOURCE_DIR "/kernels");
    std::vector<std::pair<std::size_t, std::string>> sized;
    for (const gnomon::Case* c : gnomon::find_cases(""))
        if (c->fails.empty()) sized.emplace_back(gnomon::compile_standalone(*c, sources).size(), c->name);
    std::ranges::sort(sized);
    if (sized.size() < count) throw Error("there are not {} kernels", count);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(gnomon::exactly_named(sized[i].second));
    fmt::print("the {} smallest kernels: {} to {} SPIR-V words; the largest has {}\n", count,
               sized.front().first, sized[count - 1].first, sized.back().first);
    return fmt::format("{}", fmt::join(names, ","));
}

struct Situation {
    std::string name;
    double target; ///< milliseconds; 0: none was set
    std::function<double(int)> once;
    std::vector<double> milliseconds{};
};

void measure(int runs) {
    const fs::path folder = fs::temp_directory_path() / fmt::format("gnomon-bench-{}", getpid());
    const fs::path warm = folder / "warm", kernels = folder / "kernels";
    fs::create_directories(warm);
    fs::copy(GNOMON_SOURCE_DIR "/kernels", kernels, fs::copy_options::recursive);
    const fs::path edited = kernels / "smsr/case_09.glsl";
    const std::string original = gnomon::read_file(edited);
    const std::string expression = "return ";
    if (original.find(expression) == std::string::npos) throw Error("{}: nothing to edit", edited.string());

    const std::string small = smallest_kernels(100);

    // An edit that no cache has seen, and that changes no result on the kernel's domain.
    const auto edit = [&](int i) {
        std::string text = original;
        text.insert(text.find(expression), fmt::format("if (p.x == -{}.0) return 0.5;\n    ", i + 2));
        gnomon::write_file(edited, text);
        return run({"check", "smsr/case_09", "--kernels", kernels.string()}, warm);
    };
    const auto cold = [&](int i) {
        const fs::path cache = folder / fmt::format("cold-{}", i);
        const double milliseconds = run({"check"}, cache);
        fs::remove_all(cache);
        return milliseconds;
    };
    std::vector<Situation> situations{
        // What no check can be faster than: a process that asks Vulkan for its device.
        {"devices, which runs no kernel", 0, [&](int) { return run({"devices"}, warm); }},
        {"check smsr/case_09, warm", 45,
         [&](int) {
             return run({"check", "smsr/case_09"}, warm);
         }},
        {"check smsr/case_09, after an edit", 150, edit},
        {"check smsr (15 kernels), warm", 250,
         [&](int) {
             return run({"check", "smsr/"}, warm);
         }},
        // The work that other harnesses of small kernels were timed on: a hundred kernels, few inputs each.
        {"check of the 100 smallest, few inputs", 300,
         [&](int) {
             return run({"check", small, "--samples", "1"}, warm);
         }},
        {"  the same on all their samples", 0,
         [&](int) {
             return run({"check", small}, warm);
         }},
        {"check of the 106 that are no integrals,", 0,
         [&](int) {
             return run({"check", "[!i]*", "--samples", "1"}, warm);
         }},
        {"  the same on all their samples", 0,
         [&](int) {
             return run({"check", "[!i]*"}, warm);
         }},
        {"check integral (80 kernels), warm", 1000,
         [&](int) {
             return run({"check", "integral"}, warm);
         }},
        {"check of all kernels, warm", 0, [&](int) { return run({"check"}, warm); }},
        {"check of all kernels, cold caches", 0, cold},
    };
    run({"check"}, warm);
    for (int i = 0; i < runs; ++i)
        for (Situation& situation : situations) situation.milliseconds.push_back(situation.once(i));
    fs::remove_all(folder);

    fmt::print("{} threads of {}; {} runs, 65536 samples per kernel, 8192 where truths are multiprecision\n",
               std::thread::hardware_concurrency(), processor(), runs);
    fmt::print("{:<36}{:>10}{:>16}{:>10}\n", "whole process", "median", "min to max", "target");
    for (Situation& situation : situations) {
        std::ranges::sort(situation.milliseconds);
        const std::vector<double>& ms = situation.milliseconds;
        fmt::print("{:<36}{:>7.0f} ms{:>16}{:>10}\n", situation.name, ms[ms.size() / 2],
                   fmt::format("{:.0f} to {:.0f}", ms.front(), ms.back()),
                   situation.target > 0 ? fmt::format("{:.0f} ms", situation.target) : "");
    }
}

} // namespace

int main(int argc, char** argv) {
    int runs = 15;
    if (argc > 1) {
        const std::string_view text = argv[1];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), runs);
        if (argc > 2 || error != std::errc{} || end != text.data() + text.size() || runs < 1) {
            fmt::print(stderr, "check_latency takes one number: how many runs (default 15)\n");
            return 2;
        }
    }
    try {
        measure(runs);
    } catch (const std::exception& error) {
        fmt::print(stderr, "check_latency: {}\n", error.what());
        return 2;
    }
    return 0;
}
