// PATTERN, as every verb takes it: part of a name, or a glob with *, ? or [; several apart by commas.
#pragma once

#include <string>
#include <vector>

namespace gnomon {

/// The patterns that stand apart by commas; one that is empty for an empty text, which every name matches.
/// Throws Error if nothing stands before, between or behind commas.
std::vector<std::string> split_patterns(const std::string& patterns);

/// Whether a name contains one of `patterns`, or matches it if it has *, ? or [. Throws as split_patterns
/// does.
bool matches(const std::string& name, const std::string& patterns);

} // namespace gnomon
