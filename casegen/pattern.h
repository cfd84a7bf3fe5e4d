// PATTERN, as every verb takes it.
#pragma once

#include <string>

namespace gnomon {

/// Whether a name contains `pattern`, or matches it if it has *, ? or [.
bool matches(const std::string& name, const std::string& pattern);

} // namespace gnomon
