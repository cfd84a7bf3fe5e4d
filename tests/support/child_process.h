// The built program as a child process.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gnomon::testing {

struct Ran {
    int exit_code = -1;     ///< -1 if it did not exit by itself
    bool timed_out = false; ///< had to be killed
    double seconds = 0;
    std::string out, err;
};

/// Runs gnomon to its end, or for at most `limit` seconds. `environment` is added to this process's.
Ran run_gnomon(const std::vector<std::string>& arguments,
               const std::map<std::string, std::string>& environment = {}, double limit = 100);

/// The same for any command line, through /bin/sh, with gnomon on the PATH.
Ran run_shell(const std::string& command, const std::map<std::string, std::string>& environment = {},
              double limit = 100);

} // namespace gnomon::testing
