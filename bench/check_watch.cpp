// How long an author waits for a verdict while `gnomon watch` is resident: from the save of a file to the
// line with the verdict, and to the line with the time of an evaluation before and after. Every edit is code
// that no cache has seen; targets take turns, so that a machine that slows down slows all of them alike.
// Medians and ranges.
//
//     build/bench/check_watch [EDITS]              edits per target (default 15)
//     build/bench/check_watch integrals [EDITS]    every integral in turn (default 3): how many in 100 ms
#include "casegen/catalogue.h"
#include "casegen/pattern.h"
#include "casegen/standalone.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using gnomon::Error;
using Json = nlohmann::json;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// `gnomon watch … --format json`, and the events that it tells.
class Watch {
public:
    Watch(const fs::path& kernels, const std::string& kernel) {
        const std::string pattern = gnomon::exactly_named(kernel);
        std::vector<std::string> words{GNOMON_PROGRAM, "watch",     pattern, "--format",
                                       "json",         "--kernels", kernels};
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) throw Error("no pipe");
        child_ = fork();
        if (child_ == 0) {
            dup2(ends[1], STDOUT_FILENO);
            close(ends[0]);
            execv(argv[0], argv.data());
            _exit(126);
        }
        close(ends[1]);
        out_ = ends[0];
    }
    ~Watch() {
        kill(child_, SIGINT);
        waitpid(child_, nullptr, 0);
        close(out_);
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    /// The next event of this kind, passing over others.
    Json next(const std::string& kind) {
        for (;;) {
            while (text_.find('\n') == text_.npos) {
                pollfd polled{out_, POLLIN, 0};
                if (poll(&polled, 1, 300000) <= 0) throw Error("no {} within 300 s", kind);
                std::array<char, 4096> bytes{};
                const ssize_t count = read(out_, bytes.data(), bytes.size());
                if (count <= 0) throw Error("gnomon watch ended before it told a {}", kind);
                text_.append(bytes.data(), static_cast<std::size_t>(count));
            }
            const std::size_t end = text_.find('\n');
            Json event = Json::parse(text_.substr(0, end));
            text_.erase(0, end + 1);
            if (event.at("event") == kind) return event;
            if (event.at("event") == "not_timed") throw Error("not timed: {}", event.at("message").dump());
        }
    }

private:
    pid_t child_ = -1;
    int out_ = -1;
    std::string text_;
};

constexpr double integral_target = 100; // ms

/// One text of a kernel's file, which becomes another one with every edit: {} is the edit's number.
struct Target {
    std::string what, kernel, from, to;
    bool good = true; ///< the verdict that the edit must get
    double milliseconds = 50;
    std::vector<double> verdicts{}, times{};
};

std::vector<Target> targets() {
    return {
        {"a visibility case, no result moves", "smsr/case_09", "    return 1.0 - p.y",
         "    if (p.x == -{}.5) return 0.5;\n    return 1.0 - p.y"},
        {"the same, every lit result moves", "smsr/case_09", "0.0 : 1.0;", "0.0 : 1.0 - {}e-4;", false},
        {"an RSMSS case", "rsmss/case_17", "    return type_x",
         "    if (p.x == -{}.5) return 0.5;\n    return type_x"},
        {"a visibility kernel, all its cases in it", "smsr/visibility", "    if (!lit(texel))",
         "    if (p.x == -{}.5) return 0.5;\n    if (!lit(texel))", true, 0},
        {"a cheap integral", "integral/elementary/sinc", "    return abs(x)",
         "    if (x == {}.5e30) return 0.0;\n    return abs(x)", true, integral_target},
        {"a fit", "integral/fit/l2", "    float m = lobe.m",
         "    if (lambda == -{}.5e30) return 0.0;\n    float m = lobe.m", true, integral_target},
        {"a radiance", "integral/sinc/radiance", "    if (half_width == 0.0)",
         "    if (phi == {}.5e30) return 0.0;\n    if (half_width == 0.0)", true, integral_target},
        {"the same, every result moves", "integral/sinc/radiance", "return bounded(alpha",
         "return bounded((1.0 + {}e-3) * alpha", false, integral_target},
    };
}

std::string processor() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string edited(const Target& target, const std::string& original, int edit) {
    std::string text = original;
    const std::size_t at = text.find(target.from);
    if (at == text.npos) throw Error("{} does not say \"{}\"", target.kernel, target.from);
    std::string to = target.to;
    to.replace(to.find("{}"), 2, std::to_string(edit));
    return text.replace(at, target.from.size(), to);
}

void measure_edit(Watch& watch, Target& target, const fs::path& file, const std::string& original, int edit) {
    const std::string text = edited(target, original, edit);
    const Clock::time_point start = Clock::now();
    gnomon::write_file(file, text);
    const Json verdict = watch.next("verdict");
    target.verdicts.push_back(milliseconds_since(start));
    if (verdict.at("kernel") != target.kernel || verdict.at("good") != target.good)
        throw Error("an edit of {} came to {}", target.kernel, verdict.dump());
    watch.next("time");
    target.times.push_back(milliseconds_since(start));
    if (target.good) return;
    gnomon::write_file(file, original); // so that the next edit is one of a kernel that is right
    watch.next("verdict");
    watch.next("time");
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

std::string summary(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return fmt::format("{:>5.0f} ms ({:.0f} to {:.0f})", median(values), least, most);
}

/// A watch for each target, with a folder of its own: an edit concerns nobody else.
void measure(int edits, const fs::path& folder) {
    setenv("GNOMON_CACHE", (folder / "cache").c_str(), 1);
    std::vector<Target> all = targets();
    std::vector<fs::path> folders;
    std::vector<std::unique_ptr<Watch>> watches;
    for (const Target& target : all) {
        folders.push_back(folder / std::to_string(folders.size()) / "kernels");
        fs::create_directories(folders.back().parent_path());
        fs::copy(GNOMON_SOURCE_DIR "/kernels", folders.back(), fs::copy_options::recursive);
        watches.push_back(std::make_unique<Watch>(folders.back(), target.kernel));
        watches.back()->next("settled");
    }
    for (int edit = 1; edit <= edits; ++edit)
        for (std::size_t i = 0; i < all.size(); ++i) {
            const fs::path file = folders[i] / (all[i].kernel + ".glsl");
            const std::string original =
                gnomon::read_file(GNOMON_SOURCE_DIR "/kernels/" + all[i].kernel + ".glsl");
            measure_edit(*watches[i], all[i], file, original, edit);
        }
    fmt::print("{} threads of {}; {} edits each; from the save to the line\n",
               std::thread::hardware_concurrency(), processor(), edits);
    fmt::print("{:<42}{:<26}{:>22}{:>9}{:>26}\n", "what is edited", "kernel", "verdict", "target", "time");
    for (const Target& target : all)
        fmt::print("{:<42}{:<26}{:>22}{:>9}{:>26}\n", target.what, target.kernel, summary(target.verdicts),
                   target.milliseconds > 0 ? fmt::format("{:.0f} ms", target.milliseconds) : "",
                   summary(target.times));
}

/// An edit of any kernel that moves no result: its function begins with a comparison that no input meets.
Target target_of(const gnomon::Case& c) {
    std::string function = c.name;
    std::ranges::replace(function, '/', '_');
    const std::string text = gnomon::read_file(fmt::format(GNOMON_SOURCE_DIR "/kernels/{}.glsl", c.name));
    const std::size_t head = text.find(" " + function + "("), body = text.find(") {", head);
    if (head == text.npos || body == text.npos) throw Error("{}: no function {}", c.name, function);
    const std::string whole = text.substr(head, body + 3 - head); // " name(float first, …) {"
    const std::string parameter =
        whole.substr(function.size() + 2, whole.find_first_of(",)") - function.size() - 2);
    const std::string first = parameter.substr(parameter.find(' ') + 1);
    return {.what = "",
            .kernel = c.name,
            .from = whole,
            .to = fmt::format("{}\n    if ({}{} == -{{}}.5e30) return {}(0.0);\n", whole, first,
                              parameter.starts_with("float") ? "" : ".x",
                              gnomon::glsl_name(c.reference.result))};
}

/// One after the other, each under a watch of its own.
void measure_integrals(int edits, const fs::path& folder) {
    setenv("GNOMON_CACHE", (folder / "cache").c_str(), 1);
    const fs::path kernels = folder / "kernels";
    fs::create_directories(folder);
    fs::copy(GNOMON_SOURCE_DIR "/kernels", kernels, fs::copy_options::recursive);
    const gnomon::glsl::Sources sources = gnomon::kernel_sources(kernels);

    struct Measured {
        double verdict, time;
        std::size_t words;
        std::string kernel;
    };
    std::vector<Measured> all;
    for (const gnomon::Case* c : gnomon::find_cases("integral/*")) {
        Target target = target_of(*c);
        const fs::path file = kernels / (c->name + ".glsl");
        const std::string original = gnomon::read_file(file);
        {
            Watch watch(kernels, c->name);
            watch.next("settled");
            for (int edit = 1; edit <= edits; ++edit) measure_edit(watch, target, file, original, edit);
        }
        gnomon::write_file(file, original);
        all.push_back({median(target.verdicts), median(target.times),
                       gnomon::compile_standalone(*c, sources).size(), c->name});
    }
    std::ranges::sort(all, std::greater{}, &Measured::verdict);
    const auto within =
        std::ranges::count_if(all, [](const Measured& m) { return m.verdict <= integral_target; });
    fmt::print("{} threads of {}; medians of {} edits; from the save to the line\n",
               std::thread::hardware_concurrency(), processor(), edits);
    fmt::print("{} of {} integrals have their verdict within {:.0f} ms; half of them within {:.0f} ms\n",
               within, all.size(), integral_target, all[all.size() / 2].verdict);
    fmt::print("{:<36}{:>13}{:>12}{:>12}\n", "the slowest", "SPIR-V words", "verdict", "time");
    for (const Measured& m : std::span(all).first(std::min<std::size_t>(all.size(), 12)))
        fmt::print("{:<36}{:>13}{:>9.0f} ms{:>9.0f} ms\n", m.kernel, m.words, m.verdict, m.time);
}

} // namespace

int main(int argc, char** argv) {
    const std::span<char*> words(argv + 1, static_cast<std::size_t>(argc - 1));
    const bool integrals = !words.empty() && words.front() == std::string_view("integrals");
    int edits = integrals ? 3 : 15;
    if (const std::span<char*> numbers = words.subspan(integrals ? 1 : 0); !numbers.empty()) {
        const std::string_view text = numbers.front();
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), edits);
        if (numbers.size() > 1 || error != std::errc{} || end != text.data() + text.size() || edits < 1) {
            fmt::print(stderr, "check_watch: call it with: [EDITS], or: integrals [EDITS]\n");
            return 2;
        }
    }
    const fs::path folder = fs::temp_directory_path() / fmt::format("gnomon-watch-{}", getpid());
    int exit_code = 0;
    try {
        (integrals ? measure_integrals : measure)(edits, folder);
    } catch (const std::exception& error) {
        fmt::print(stderr, "check_watch: {}\n", error.what());
        exit_code = 2;
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return exit_code;
}
