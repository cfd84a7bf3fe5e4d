// A hybrid bench as files: a page, its picture alone, and numbers for programs.
#pragma once

#include "casegen/measure/hybrid/bench.h"

#include <filesystem>
#include <string>

namespace gnomon::measure {

/// Time against what is uncertain, and against what is wrong: a column of panels per viewport; a technique's
/// shadow maps are joined by a line. Techniques that another one dominates are hollow.
std::string hybrid_chart(const HybridBench& bench);

/// One page with all tables and the picture that needs nothing but itself.
std::string hybrid_page(const HybridBench& bench);

/// Writes report.html, hybrid.json, hybrid.csv and hybrid_pareto.svg into a folder that require_report_folder
/// made. Throws Error.
void write_report(const std::filesystem::path& folder, const HybridBench& bench);

} // namespace gnomon::measure
