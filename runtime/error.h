// What can go wrong outside the program, as exceptions whose message a user can act on.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace gnomon {

/// Something outside the program is not as it must be: a file, an option, a device, a driver.
/// what() is one line that says what is wrong, where, and what to do. The program prints it and exits with 2.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}

    template <typename... Args>
    explicit Error(fmt::format_string<Args...> format, Args&&... args)
        : std::runtime_error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// A kernel does not compile. what() starts with "kernels/smsr/case_09.glsl:12: ": the author's file and
/// line.
class CompileError : public Error {
public:
    using Error::Error;
};

/// A dispatch did not end within the device's time limit, or the device was lost while it ran. The device it
/// ran on cannot be used, nor torn down, any more.
class KernelTimeout : public Error {
public:
    using Error::Error;
};

} // namespace gnomon
