// What tests look at texts and words with.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gnomon::testing {

inline std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

/// How often `what` begins in `text`.
inline std::size_t count_of(std::string_view text, std::string_view what) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
    return count;
}

} // namespace gnomon::testing
