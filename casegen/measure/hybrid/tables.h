// What a hybrid bench found, as tables for people and as rows for programs.
#pragma once

#include "casegen/measure/hybrid/bench.h"
#include "casegen/measure/tables.h"

#include <string>
#include <vector>

namespace gnomon::measure {

/// A row per technique: steps and whole frames as parts of raytraced's frame, rays, memory, break-even, wrong
/// pixels; how auto did below.
Table hybrid_table(const HybridCombination& combination);

std::string to_text(const HybridBench& bench);

/// Machine, scene, and what the numbers are.
std::vector<std::string> remarks(const HybridBench& bench);

/// One line per combination and technique, and a header.
std::string hybrid_csv(const HybridBench& bench);
/// JSON has no infinity: a break-even that no ray reaches is null.
std::string hybrid_json(const HybridBench& bench);

} // namespace gnomon::measure
