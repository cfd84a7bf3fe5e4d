// All kernels of a bench at one look.
#pragma once

#include "casegen/measure/bench.h"
#include "casegen/measure/tables.h"

#include <string>

namespace gnomon::measure {

/// The 99 % error against time, if there are times, and against instructions: a dot per kernel and mode, by
/// family; hollow where another variant of its quantity dominates it.
std::string overview_chart(const Bench& bench);

/// A row per kernel and mode: errors, time, instructions, who dominates it.
Table overview_table(const Bench& bench);

/// What a kernel's result has beyond its tolerance within its own domain, one line each.
std::vector<std::string> failures(const Bench& bench);

} // namespace gnomon::measure
