// A kernel's text with what its inputs reached of it.
#pragma once

#include "casegen/coverage/measure.h"

#include <string>

namespace gnomon::atlas {

/// A table, a row per line: how often it was reached ("never" if not, "random samples only" if the fixtures
/// did not), its number, its text, and below that how often each branch on it went which way.
std::string listing_html(const coverage::FileCoverage& file);

/// "6 of 6 lines, 7 of 8 branches (by the fixtures alone 6 and 5)".
std::string reached_in_words(const coverage::FileCoverage& file);

} // namespace gnomon::atlas
