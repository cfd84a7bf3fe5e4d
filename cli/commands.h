// The program's verbs. Each file of this folder adds one to the command line.
#pragma once

#include "runtime/gpu/device.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

namespace gnomon::cli {

/// Options that every verb shares.
struct Common {
    std::filesystem::path kernels;
    gpu::DeviceOptions device;
};

/// What PATTERN is.
constexpr const char* pattern_help =
    "part of a name, or a pattern with *, ? or [; several apart by commas (default: all)";

/// Each adds a subcommand whose callback does the work; a callback sets `exit_code` to 1 when what was
/// examined is wrong, and throws Error (exit code 2) when what it was given is.
void add_devices(CLI::App& app, Common& common);
void add_list(CLI::App& app, Common& common);
void add_describe(CLI::App& app, Common& common);
void add_witnesses(CLI::App& app, Common& common);
void add_check(CLI::App& app, Common& common, int& exit_code);
void add_eval(CLI::App& app, Common& common, int& exit_code);
void add_capture(CLI::App& app, Common& common, int& exit_code);
void add_revectorize(CLI::App& app, Common& common);
void add_render(CLI::App& app, Common& common);
void add_census(CLI::App& app, Common& common, int& exit_code);
void add_atlas(CLI::App& app, Common& common, int& exit_code);
void add_bench(CLI::App& app, Common& common, int& exit_code);
void add_bench_hybrid(CLI::App& bench, Common& common, int& exit_code); // bench's own
void add_worst(CLI::App& app, Common& common, int& exit_code);
void add_coverage(CLI::App& app, Common& common, int& exit_code);
void add_fuzz(CLI::App& app, Common& common, int& exit_code);
void add_mutate(CLI::App& app, Common& common, int& exit_code);
void add_watch(CLI::App& app, Common& common, int& exit_code);
void add_compare(CLI::App& app, Common& common, int& exit_code);
void add_reproduce(CLI::App& app, Common& common);
void add_demo(CLI::App& app, Common& common, int& exit_code);

} // namespace gnomon::cli
