// Another program, run to its end without a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

struct CommandResult {
    int exit_code = 0; ///< 128 + the number of the signal that ended it
    std::string out, err;
};

/// `words` are the program, looked for on the PATH, and its arguments; it reads `input`. Throws Error if the
/// program cannot be started: "git: not found".
CommandResult run_command(const std::vector<std::string>& words, std::string_view input = {});

} // namespace gnomon
