// What check found, as text for people, JSON for programs, JUnit for continuous integration.
#pragma once

#include "casegen/check.h"

#include <span>
#include <string>

namespace gnomon::cli {

/// A table; below it, for each kernel that fails, the exact call, got, want, allowed, and the command that
/// replays it: with `options`, see replay_command.
std::string check_text(std::span<const CheckReport> reports, const std::string& options = {});
std::string check_json(std::span<const CheckReport> reports, const std::string& options = {});
std::string check_junit(std::span<const CheckReport> reports, const std::string& options = {});

/// Throws Error with the first message if the validation layer said anything.
void require_no_validation_messages();

} // namespace gnomon::cli
