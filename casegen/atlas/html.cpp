#include "casegen/atlas/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace gnomon::atlas {
namespace {

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_keyword(std::string_view word) {
    static constexpr std::array words{"void",   "bool",   "int",    "uint",  "float",   "vec2",  "vec3",
                                      "vec4",   "ivec2",  "ivec3",  "ivec4", "uvec2",   "uvec3", "uvec4",
                                      "bvec2",  "bvec3",  "bvec4",  "const", "if",      "else",  "for",
                                      "while",  "do",     "switch", "case",  "default", "break", "continue",
                                      "return", "struct", "in",     "out",   "inout",   "true",  "false"};
    return std::ranges::find(words, word) != words.end();
}

std::string span(const char* what, std::string_view text) {
    return fmt::format("<span class=\"{}\">{}</span>", what, escape_html(text));
}

} // namespace

std::string escape_html(std::string_view text) {
    std::string escaped;
    escaped.reserve(text.size());
    for (const char c : text) switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
        }
    return escaped;
}

std::string base64(std::string_view bytes) {
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = group << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i) text += i <= count ? digits[group >> (18 - 6 * i) & 63u] : '=';
    }
    return text;
}

std::string data_uri(const Image& image) { return "data:image/png;base64," + base64(encode_png(image)); }

std::string glsl_to_html(std::string_view text) {
    std::string html;
    bool line_begins = true;
    for (std::size_t at = 0; at < text.size();) {
        const auto rest_of_line = [&] { return text.substr(at, text.substr(at).find('\n')); };
        std::string_view part = text.substr(at, 1);
        const char* what = nullptr;
        if (text.substr(at, 2) == "//") {
            part = rest_of_line();
            what = "c";
        } else if (text.substr(at, 2) == "/*") {
            const std::size_t end = text.find("*/", at + 2);
            part = text.substr(at, end == text.npos ? end : end + 2 - at);
            what = "c";
        } else if (line_begins && text[at] == '#') {
            part = rest_of_line();
            what = "d";
        } else if (is_word(text[at])) {
            const bool number = text[at] >= '0' && text[at] <= '9';
            std::size_t end = at;
            while (end < text.size() && (is_word(text[end]) || (number && text[end] == '.'))) ++end;
            part = text.substr(at, end - at);
            what = number ? "n" : is_keyword(part) ? "k" : nullptr;
        }
        html += what ? span(what, part) : escape_html(part);
        if (part == "\n")
            line_begins = true;
        else if (part != " ")
            line_begins = false;
        at += part.size();
    }
    return html;
}

} // namespace gnomon::atlas
