#include "tests/support/running.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gnomon::testing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

Running::Running(const std::vector<std::string>& arguments) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    std::vector<std::string> command{GNOMON_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : command) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ == 0) {
        ::dup2(::open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
        ::dup2(ends[1], STDOUT_FILENO);
        ::execv(pointers[0], pointers.data());
        ::_exit(126);
    }
    ::close(ends[1]);
    out_ = ends[0];
}

Running::~Running() {
    if (pid_ > 0) {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    if (out_ >= 0) ::close(out_);
}

std::optional<std::string> Running::line(double seconds) {
    const Clock::time_point start = Clock::now();
    for (;;) {
        if (const std::size_t end = partial_.find('\n'); end != partial_.npos) {
            std::string line = partial_.substr(0, end);
            partial_.erase(0, end + 1);
            return line;
        }
        pollfd polled{out_, POLLIN, 0};
        const double left = std::max(0.0, seconds - seconds_since(start));
        if (::poll(&polled, 1, static_cast<int>(left * 1000)) <= 0) return {};
        std::array<char, 4096> bytes{};
        const ssize_t count = ::read(out_, bytes.data(), bytes.size());
        if (count <= 0) return {};
        partial_.append(bytes.data(), static_cast<std::size_t>(count));
    }
}

int Running::exit_code() {
    const Clock::time_point start = Clock::now();
    int status = 0;
    while (::waitpid(pid_, &status, WNOHANG) == 0) {
        if (seconds_since(start) > 100) return -1;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace gnomon::testing
