#include "runtime/glsl/names.h"

#include <algorithm>

namespace gnomon::glsl {
namespace {

/// SPIR-V's numbers of instructions [The SPIR-V Specification, 3.42.2 and 3.42.3].
bool is_a_name(std::uint32_t operation) {
    constexpr std::uint32_t op_source_continued = 2, op_line = 8; // in between: source, names, strings
    constexpr std::uint32_t op_no_line = 317, op_module_processed = 330;
    return (operation >= op_source_continued && operation <= op_line) || operation == op_no_line ||
           operation == op_module_processed;
}

} // namespace

Spirv without_names(const Spirv& words) {
    constexpr std::size_t header = 5;
    Spirv kept(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(std::min(header, words.size())));
    for (std::size_t i = header; i < words.size();) {
        const std::size_t end = std::min(words.size(), i + std::max(words[i] >> 16, 1u));
        if (!is_a_name(words[i] & 0xffffu))
            kept.insert(kept.end(), words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(end));
        i = end;
    }
    return kept;
}

} // namespace gnomon::glsl
