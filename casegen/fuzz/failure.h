// What went wrong with one input, in few words: inputs that fail in the same words are one failure to whoever
// shrinks them, counts them or files them.
#pragma once

#include "casegen/compare.h"
#include "casegen/csv.h"
#include "casegen/standalone.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gnomon::fuzz {

/// One input of a kernel: word_count(case) words; a mask if it takes one.
using Input = CsvInput;

/// "NaN", "out of range", "wrong"; of a kernel that looks at a mask with the number of the texel's case,
/// "wrong in case 9"; "…, outside the domain". Empty for a result that passes.
std::string failure_of(const Case& c, const Arguments& arguments, std::span<const std::uint32_t> result,
                       const Agreement& agreement);

/// Of every record, for results that were all written: empty where they pass. `truths`: one for each, or
/// none.
std::vector<std::string> failures_of(const Case& c, const Records& records, const Outputs& outputs,
                                     std::span<const Truth> truths);

// Failures of a whole dispatch, which no result tells.
inline constexpr const char* unwritten = "never written";
inline constexpr const char* stray_write = "stray write";
inline constexpr const char* unstable = "unstable";
inline constexpr const char* timeout = "timeout";
inline constexpr const char* crash = "crash";

} // namespace gnomon::fuzz
