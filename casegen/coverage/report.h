// What was measured, for people and programs.
#pragma once

#include "casegen/coverage/measure.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::coverage {

/// Something that was never reached, or by random samples only.
struct Gap {
    int line = 1;
    std::string what; ///< "`a < b` was never false", "was reached only by random samples: `return 0u;`"
    bool by_samples = false;
    std::string replay{}; ///< the command that runs a random sample that did
};

/// By line. Within what was never reached itself nothing further is named. Random samples count only if
/// `with_samples`.
std::vector<Gap> gaps(const FileCoverage& file, bool with_samples);

/// A row per file: of lines, branches (outcomes) and functions how many the fixtures reached, and how many
/// with random samples; the sums; kernels that could not be measured. With `missing`, below it, the gaps of
/// every file as "smsr/case_09.glsl:7: …" and what bears no counters.
std::string to_text(const Coverage& coverage, bool missing);

/// The same, with every line, branch and function, and how often each was reached.
std::string to_json(const Coverage& coverage);

/// LCOV's tracefile, for genhtml and what else reads it: the counts of fixtures and samples together, of
/// files below the folder `kernels` (generated texts are no files and are left out). A branch's outcomes
/// stand in the order of Branch::outcomes; "-" is an outcome of a branch that was never asked.
std::string to_lcov(const Coverage& coverage, const std::filesystem::path& kernels);

} // namespace gnomon::coverage
