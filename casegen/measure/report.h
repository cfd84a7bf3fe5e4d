// A bench as files: a page, its pictures alone, and numbers for programs.
#pragma once

#include "casegen/measure/bench.h"
#include "casegen/measure/frames/frames.h"
#include "casegen/measure/moved.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::measure {

/// All that was measured, and what else the page shows.
struct Report {
    Bench bench;
    std::vector<SceneResult> scenes{};  ///< techniques
    std::optional<Moved> moved{};       ///< against a baseline
    std::string baseline{};             ///< its name
    std::string mutation{}, coverage{}; ///< mutation_section, coverage_section; empty: not shown
};

/// JSON has no infinity: what is not finite is null. With `details`, classes and loci of inputs too.
std::string bench_json(const Report& report, bool details = true);

/// One page with all tables and pictures that needs nothing but itself.
std::string bench_page(const Report& report);

/// Whatever is wrong without a baseline: kernels beyond their tolerance, techniques that break their promise.
std::vector<std::string> all_failures(const Report& report);

/// Writes report.html, bench.json, and <quantity>_distance.svg and <quantity>_pareto.svg, '/' as '_', where
/// there is something to see. Throws Error.
void write_report(const std::filesystem::path& folder, const Report& report);

/// Makes the folder if it is missing. Throws Error now if write_report would later.
void require_report_folder(const std::filesystem::path& folder);

} // namespace gnomon::measure
