// A bench as files: a page, its pictures alone, and numbers for programs.
#pragma once

#include "casegen/measure/bench.h"

#include <filesystem>
#include <string>

namespace gnomon::measure {

/// JSON has no infinity: what is not finite is null.
std::string bench_json(const Bench& bench);

/// One page with all tables and pictures that needs nothing but itself.
std::string bench_page(const Bench& bench);

/// Writes report.html, bench.json, and <quantity>_distance.svg and <quantity>_pareto.svg, '/' as '_', where
/// there is something to see. Throws Error.
void write_report(const std::filesystem::path& folder, const Bench& bench);

/// Makes the folder if it is missing. Throws Error now if write_report would later.
void require_report_folder(const std::filesystem::path& folder);

} // namespace gnomon::measure
