// Option values with a shape of their own.
#pragma once

#include <glm/glm.hpp>

#include <string>
#include <utility>

namespace gnomon::cli {

/// "1,-2.5,3e2". Throws Error naming the option.
glm::vec3 parse_vector(const std::string& text, const char* option);

/// "1024x768". Throws Error naming the option.
std::pair<int, int> parse_size(const std::string& text, const char* option);

} // namespace gnomon::cli
