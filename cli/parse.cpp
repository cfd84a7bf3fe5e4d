#include "cli/parse.h"

#include "runtime/error.h"
#include "runtime/files.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace gnomon::cli {

glm::vec3 parse_vector(const std::string& text, const char* option) {
    glm::vec3 result(0);
    const char* at = text.c_str();
    for (int i = 0; i < 3; ++i) {
        char* end = nullptr;
        result[i] = std::strtof(at, &end);
        if (end == at || *end != (i < 2 ? ',' : '\0'))
            throw Error("{} is \"{}\"; three numbers X,Y,Z without blanks are needed", option, text);
        at = end + 1;
    }
    return result;
}

std::pair<int, int> parse_size(const std::string& text, const char* option) {
    const std::size_t x = text.find('x');
    const auto number = [&](std::string_view part) {
        int value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (x == std::string::npos || part.empty() || error != std::errc{} ||
            end != part.data() + part.size())
            throw Error("{} is \"{}\"; WIDTHxHEIGHT is needed, as 1024x768", option, text);
        return value;
    };
    const std::string_view view = text;
    return {number(view.substr(0, x)), number(view.substr(x == std::string::npos ? view.size() : x + 1))};
}

std::optional<std::uint64_t> parse_seed(const std::string& text) {
    if (text.empty()) return {};
    std::size_t used = 0;
    try {
        const std::uint64_t seed = std::stoull(text, &used, 0);
        if (used == text.size() && text.front() != '-') return seed;
    } catch (const std::exception&) {
        used = 0;
    }
    throw Error("--seed is \"{}\"; a whole number below 2^64 is needed, decimal or 0x…", text);
}

std::uint64_t parse_count(const std::string& text, const char* option) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // 2^50: far below where doubles skip whole numbers.
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= 1 && value <= 0x1p50) ||
        std::floor(value) != value)
        throw Error("{} is \"{}\"; a whole number from 1 to 2^50 is needed, as 300000 or 1e9", option, text);
    return static_cast<std::uint64_t>(value);
}

CLI::Validator number_from(double least, double most) {
    const std::string range = fmt::format("{:g} to {:g}", least, most);
    return {[least, most, range](std::string& text) {
                double value = 0;
                const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
                const bool fits = error == std::errc{} && end == text.data() + text.size() &&
                                  value >= least && value <= most; // NaN is not
                return fits ? "" : fmt::format("Value {} not in range {}", text, range);
            },
            "FLOAT in [" + range + "]"};
}

std::string replay_options(const CLI::App& app) {
    std::string text;
    for (const char* option : {"--kernels", "--device"})
        if (app.count(option) > 0)
            text += fmt::format(" {} {}", option, in_quotes(app.get_option(option)->as<std::string>()));
    return text;
}

} // namespace gnomon::cli
