#include "tests/support/child_process.h"

#include "runtime/files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gnomon::testing {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A file for one stream of the child: a file cannot fill up and block it as a pipe would.
class Stream {
public:
    explicit Stream(const char* what)
        : path_(
              (fs::path(::testing::TempDir()) / fmt::format("gnomon-child-{}-{}", getpid(), what)).string()),
          handle_(open(path_.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600)) {}
    ~Stream() {
        close(handle_);
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    int handle() const { return handle_; }
    std::string text() const { return read_file(path_); }

private:
    std::string path_;
    int handle_;
};

[[noreturn]] void become(std::vector<std::string> command, const std::map<std::string, std::string>& added,
                         const Stream& out, const Stream& err) {
    for (const auto& [name, value] : added) setenv(name.c_str(), value.c_str(), 1);
    dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
    dup2(out.handle(), STDOUT_FILENO);
    dup2(err.handle(), STDERR_FILENO);
    std::vector<char*> pointers;
    for (std::string& word : command) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(pointers[0], pointers.data());
    _exit(126);
}

Ran run(const std::vector<std::string>& command, const std::map<std::string, std::string>& environment,
        double limit) {
    const Stream out("out"), err("err");
    const Clock::time_point start = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const pid_t child = fork();
    if (child == 0) become(command, environment, out, err);

    Ran ran;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (seconds() > limit) {
            ran.timed_out = true;
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ran.seconds = seconds();
    if (WIFEXITED(status)) ran.exit_code = WEXITSTATUS(status);
    ran.out = out.text();
    ran.err = err.text();
    return ran;
}

} // namespace

Ran run_gnomon(const std::vector<std::string>& arguments,
               const std::map<std::string, std::string>& environment, double limit) {
    std::vector<std::string> command{GNOMON_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run(command, environment, limit);
}

Ran run_shell(const std::string& command, const std::map<std::string, std::string>& environment,
              double limit) {
    const std::string path = fs::path(GNOMON_PROGRAM).parent_path().string();
    return run({"/bin/sh", "-c", fmt::format("PATH='{}':$PATH; {}", path, command)}, environment, limit);
}

} // namespace gnomon::testing
