// A progress bar on standard error, where a person is watching.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace gnomon::cli {

/// Shows itself only if standard error is a terminal and the work lasts more than half a second; leaves
/// nothing behind.
class Progress {
public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(std::size_t done, std::size_t total);

private:
    std::string what_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    bool terminal_ = false, shown_ = false;
};

} // namespace gnomon::cli
