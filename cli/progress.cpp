#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace gnomon::cli {

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(std::size_t done, std::size_t total) {
    if (!terminal_ || total == 0) return;
    if (std::chrono::steady_clock::now() - start_ < std::chrono::milliseconds(500)) return;
    constexpr std::size_t width = 30;
    const std::size_t filled = std::min(width, width * done / total);
    fmt::print(stderr, "\r\x1b[K{} [{:<{}}] {}/{}", what_, std::string(filled, '='), width, done, total);
    std::fflush(stderr);
    shown_ = true;
}

} // namespace gnomon::cli
