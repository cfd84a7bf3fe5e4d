// The built program in the background: what it prints is read while it runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <csignal>
#include <sys/types.h>

namespace gnomon::testing {

/// Its standard output is a pipe to us, standard error is ours. Killed with this object.
class Running {
public:
    explicit Running(const std::vector<std::string>& arguments);
    ~Running();
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    /// The next line without its end; nothing if none comes within so many seconds, or ever.
    std::optional<std::string> line(double seconds = 100);
    void signal(int number) const { ::kill(pid_, number); }
    /// Waits for it to end by itself. Its exit code; -1 if it did not exit, or did not end within 100 s.
    int exit_code();

private:
    pid_t pid_ = -1;
    int out_ = -1;
    std::string partial_;
};

} // namespace gnomon::testing
