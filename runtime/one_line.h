// Text of unknown origin as part of a message, which is one line.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace gnomon {

/// Control characters become blanks; those at the end go.
inline std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

} // namespace gnomon
