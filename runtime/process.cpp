#include "runtime/process.h"

#include "runtime/clock.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <utility>
#include <vector>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gnomon {
namespace {

// A message on the wire: its kind, its length, its bytes.
struct Header {
    std::uint64_t kind = 0, length = 0;
};

/// False if the other side is gone.
bool write_all(int socket, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
}

bool write_message(int socket, Answer::Kind kind, std::string_view text) {
    const Header header{static_cast<std::uint64_t>(kind), text.size()};
    std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
    bytes += text;
    return write_all(socket, bytes);
}

/// False at the end.
bool read_exactly(int socket, char* to, std::size_t count) {
    while (count > 0) {
        const ssize_t n = ::read(socket, to, count);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        to += n;
        count -= static_cast<std::size_t>(n);
    }
    return true;
}

Answer attempt(const std::function<std::string()>& work) {
    try {
        return {Answer::Kind::message, work()};
    } catch (const std::exception& error) {
        return {Answer::Kind::error, error.what()};
    }
}

[[noreturn]] void serve_for_ever(int socket, const Child::Start& start) {
    Child::Serve serve;
    const Answer begun = attempt([&] {
        serve = start();
        return std::string();
    });
    Header header;
    while (read_exactly(socket, reinterpret_cast<char*>(&header), sizeof header)) {
        std::string request(header.length, '\0');
        if (!read_exactly(socket, request.data(), request.size())) break;
        const Answer answer =
            begun.kind == Answer::Kind::error ? begun : attempt([&] { return serve(request); });
        if (!write_message(socket, answer.kind, answer.text)) break;
    }
    ::_exit(0); // no destructors: a driver's threads may be past joining
}

/// poll() until `deadline`, whatever signals arrive but one that wants this process to stop waiting.
bool readable(std::vector<pollfd>& polled, double deadline) {
    for (;;) {
        const double left = std::clamp(deadline - seconds_now(), 0.0, 1e6);
        const int ready = ::poll(polled.data(), polled.size(), static_cast<int>(left * 1000 + 0.999));
        if (ready > 0) return true;
        if (ready < 0 && errno != EINTR) throw Error("waiting for a child failed: {}", std::strerror(errno));
        if (ready < 0 || seconds_now() >= deadline) return false;
    }
}

} // namespace

Child::Child(const Start& start) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw Error("no channel to a child process: {}", std::strerror(errno));
    std::fflush(nullptr); // else a child that exits in an unforeseen way prints our lines again
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ < 0) {
        const int reason = errno;
        ::close(ends[0]);
        ::close(ends[1]);
        throw Error("no further process can be started: {}", std::strerror(reason));
    }
    if (pid_ == 0) {
        ::close(ends[0]);
        std::signal(SIGINT, SIG_IGN);
        std::signal(SIGTERM, SIG_IGN); // sent to a whole group: the parent ends its children itself
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) ::_exit(0); // it died before the line above
        serve_for_ever(ends[1], start);
    }
    ::close(ends[1]);
    socket_ = ends[0];
}

Child::Child(Child&& other) noexcept { *this = std::move(other); }

Child& Child::operator=(Child&& other) noexcept {
    std::swap(pid_, other.pid_);
    std::swap(socket_, other.socket_);
    std::swap(busy_, other.busy_);
    std::swap(partial_, other.partial_);
    std::swap(end_, other.end_);
    return *this;
}

Child::~Child() {
    if (pid_ > 0) {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    if (socket_ >= 0) ::close(socket_);
}

void Child::kill() {
    if (pid_ > 0) ::kill(pid_, SIGKILL);
}

void Child::send(std::string_view request) {
    busy_ = true;
    write_message(socket_, Answer::Kind::message, request); // if nobody reads it, receive will know
}

Answer Child::ended() {
    busy_ = false;
    if (end_.empty()) {
        int status = 0;
        ::waitpid(pid_, &status, 0);
        pid_ = -1;
        end_ = WIFSIGNALED(status)
                   ? fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)))
                   : fmt::format("exit code {}", WEXITSTATUS(status));
    }
    return {Answer::Kind::death, end_};
}

Answer Child::receive(double seconds) {
    if (!end_.empty()) return ended();
    const double deadline = seconds_now() + seconds;
    for (;;) {
        Header header;
        if (partial_.size() >= sizeof header) {
            std::memcpy(&header, partial_.data(), sizeof header);
            if (partial_.size() == sizeof header + header.length) {
                Answer answer{static_cast<Answer::Kind>(header.kind), partial_.substr(sizeof header)};
                partial_.clear();
                busy_ = false;
                return answer;
            }
        }
        std::vector<pollfd> polled{{socket_, POLLIN, 0}};
        if (!readable(polled, deadline)) return {Answer::Kind::late, {}};
        char bytes[1 << 16];
        const std::size_t missing = partial_.size() < sizeof header
                                        ? sizeof header - partial_.size()
                                        : sizeof header + header.length - partial_.size();
        const ssize_t n = ::read(socket_, bytes, std::min(missing, sizeof bytes));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            if (pid_ > 0) ::kill(pid_, SIGKILL); // it may have closed its end and live on
            return ended();
        }
        partial_.append(bytes, static_cast<std::size_t>(n));
    }
}

std::size_t wait_for_any(std::span<const Child> children, double seconds) {
    std::vector<pollfd> polled;
    for (const Child& child : children) // a negative descriptor is passed over
        polled.push_back({child.busy() ? child.descriptor() : -1, POLLIN, 0});
    if (!readable(polled, seconds_now() + seconds)) return children.size();
    const auto speaks = [](const pollfd& entry) { return entry.revents != 0; };
    return static_cast<std::size_t>(std::ranges::find_if(polled, speaks) - polled.begin());
}

} // namespace gnomon
