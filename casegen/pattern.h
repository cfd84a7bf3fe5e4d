// PATTERN, as every verb takes it: part of a name, or a glob with *, ? or [; several apart by commas, which
// no pattern holds.
#pragma once

#include <string>
#include <vector>

namespace gnomon {

/// The patterns that stand apart by commas; of an empty text one, empty, which every name matches. Throws
/// Error if nothing stands before, between or behind commas.
std::vector<std::string> split_patterns(const std::string& patterns);

/// Whether a name contains one of `patterns`, or matches it if it has *, ? or [. Throws as split_patterns
/// does.
bool matches(const std::string& name, const std::string& patterns);

/// The pattern that this name alone matches: by itself it is part of others too.
std::string exactly_named(const std::string& name);

} // namespace gnomon
