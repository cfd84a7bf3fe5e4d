// The whole command line.
#pragma once

#include "cli/commands.h"

#include <memory>
#include <string>

namespace gnomon::cli {

/// With all verbs. Parsing a command line runs the verb that it names (see commands.h). `common` and
/// `exit_code` must outlive it.
std::unique_ptr<CLI::App> make_app(Common& common, int& exit_code);

/// Throws Error with the verbs that there are if the command line's first word is neither one nor an option.
void require_verb(const CLI::App& app, const std::string& word);

} // namespace gnomon::cli
