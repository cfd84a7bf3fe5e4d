// Option values with a shape of their own.
#pragma once

#include <CLI/CLI.hpp>
#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace gnomon::cli {

/// "1,-2.5,3e2". Throws Error naming the option.
glm::vec3 parse_vector(const std::string& text, const char* option);

/// "1024x768". Throws Error naming the option.
std::pair<int, int> parse_size(const std::string& text, const char* option);

/// "7", "0x1f"; nothing for an empty text. Throws Error if it is not a whole number below 2^64.
std::optional<std::uint64_t> parse_seed(const std::string& text);

/// How many: "300000", "1e9", "2.5e6". Throws Error naming the option if it is not a whole number from 1 to
/// 2^50.
std::uint64_t parse_count(const std::string& text, const char* option);

/// A check for options that are a number from `least` to `most`. (CLI::Range lets NaN pass.)
CLI::Validator number_from(double least, double most);

/// What a command that replays a finding must say besides: these kernels, this device.
std::string replay_options(const CLI::App& app);

} // namespace gnomon::cli
