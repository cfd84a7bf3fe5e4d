// What other verbs found, as parts of a page: from the JSON files that they write.
#pragma once

#include <string>

namespace gnomon::measure {

/// Mutation scores per kernel and of all mutants, and each that survived, from the JSON of gnomon mutate.
/// `name` stands for the text in messages. Throws Error, in one line: not JSON, a member that is missing or
/// not what it must be.
std::string mutation_section(const std::string& json, const std::string& name);

/// Lines, branches and functions that were reached per file, from the JSON of gnomon coverage. Throws as
/// above.
std::string coverage_section(const std::string& json, const std::string& name);

} // namespace gnomon::measure
