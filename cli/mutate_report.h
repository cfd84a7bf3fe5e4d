// What mutation testing found, as text for people, JSON for programs, JUnit for continuous integration.
#pragma once

#include "casegen/mutate/campaign.h"

#include <string>

namespace gnomon::cli {

/// A table of kernels; below it every survivor with its line before and after and the command that shows it
/// (with `options`, see replay_command), and whatever is wrong with the list of equivalents.
std::string mutate_text(const mutate::CampaignReport& report, const glsl::Sources& sources,
                        const std::string& options = {});
/// {"kernels": [{"name", "mutants", "killed", "equivalent", "tolerated" (part of the equivalent),
/// "same_code", "stillborn", "not_run", "score", "survived": [{"id", "file", "line", "column", "operator",
/// "before", "after", "how"}]}], "all": the same of every mutant once, "complaints": […], "interrupted",
/// "seconds"}.
std::string mutate_json(const mutate::CampaignReport& report);
/// A test case per kernel, failed where a mutant survives.
std::string mutate_junit(const mutate::CampaignReport& report, const glsl::Sources& sources);

/// One mutant in full: what it is and what became of it.
std::string mutant_text(const mutate::MutantReport& report, const glsl::Sources& sources);

} // namespace gnomon::cli
