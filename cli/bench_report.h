// What bench found, on standard output: as text for people, as JUnit for continuous integration.
#pragma once

#include "casegen/measure/report.h"

#include <string>

namespace gnomon::cli {

/// Against a baseline only what moved; else every table.
std::string bench_text(const measure::Report& report, bool by_class);

/// A case per kernel and mode and per technique and scene. It fails if it is worse than the baseline's, or,
/// whatever the baseline says, a kernel that is beyond its tolerance or a technique that breaks its promise.
std::string bench_junit(const measure::Report& report);

/// Whether anything fails.
bool is_bad(const measure::Report& report);

} // namespace gnomon::cli
