// The whole command line.
#pragma once

#include "cli/commands.h"

#include <memory>
#include <string>
#include <string_view>

namespace gnomon::cli {

/// Parsing a command line runs the verb that it names (see commands.h). If its `first` word names a verb only
/// that one is there, since describing all of them takes two milliseconds; else all are. `common` and
/// `exit_code` must outlive it.
std::unique_ptr<CLI::App> make_app(Common& common, int& exit_code, std::string_view first);

/// Throws Error with the verbs that there are if the command line's first word is neither one nor an option.
void require_verb(const std::string& word);

} // namespace gnomon::cli
