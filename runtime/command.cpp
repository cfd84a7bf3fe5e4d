#include "runtime/command.h"

#include "runtime/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gnomon {
namespace {

/// A file without a name: the program's three streams are such, so that neither side waits for the other.
class Stream {
public:
    Stream() : file_(std::tmpfile()) {
        if (!file_) throw Error("no temporary file for a program's output: {}", std::strerror(errno));
    }
    int descriptor() const { return ::fileno(file_.get()); }

    void fill(std::string_view bytes) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
            std::fflush(file_.get()) != 0)
            throw Error("no room for a program's input in the temporary folder: {}", std::strerror(errno));
        ::lseek(descriptor(), 0, SEEK_SET);
    }

    std::string all() {
        ::lseek(descriptor(), 0, SEEK_SET);
        std::string text;
        char bytes[1 << 16];
        for (ssize_t n = 1; n > 0;) {
            n = ::read(descriptor(), bytes, sizeof bytes);
            if (n > 0) text.append(bytes, static_cast<std::size_t>(n));
        }
        return text;
    }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
};

} // namespace

CommandResult run_command(const std::vector<std::string>& words, std::string_view input) {
    Stream in, out, err;
    in.fill(input);
    std::vector<std::string> held = words;
    std::vector<char*> arguments;
    for (std::string& word : held) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
    pid_t pid = -1;
    const int failure =
        ::posix_spawnp(&pid, arguments.front(), &actions, nullptr, arguments.data(), ::environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (failure == ENOENT) throw Error("{}: not found; it must be installed, and on the PATH", words.front());
    if (failure != 0) throw Error("{}: cannot be started: {}", words.front(), std::strerror(failure));
    int status = 0;
    while (::waitpid(pid, &status, 0) < 0)
        if (errno != EINTR) throw Error("{}: lost sight of it: {}", words.front(), std::strerror(errno));
    const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return {code, out.all(), err.all()};
}

} // namespace gnomon
