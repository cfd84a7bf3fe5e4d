// The simplest input that still fails in the same words: many simpler candidates at once, the simplest of
// those that fail is kept, and again, until none of them does.
#pragma once

#include "casegen/fuzz/failure.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace gnomon::fuzz {

/// How far an input is from what one would write by hand, the less the simpler: texels of the mask first,
/// then how many of them are shadow, what lies outside, then the digits of its numbers. 0 and 1 are the
/// simplest floats, then few bits of mantissa and small exponents; what is not finite is the least simple.
double complexity(const Case& c, const Input& input);

/// A float's word with all but the first `digits` bits of its mantissa dropped, or rounded to them.
std::uint32_t with_digits(std::uint32_t word, int digits, bool rounded);

/// Per candidate whether it fails as the first one did.
using StillFails = std::function<std::vector<bool>(std::span<const Input> candidates)>;

struct ShrinkOptions {
    std::size_t candidates = 8192; ///< at most so many at once
    std::size_t rounds = 100;      ///< at most so many times
    /// All masks of up to 3x3 texels are tried before anything else, so many inputs at once; 0: they are not.
    std::size_t small_masks_at_once = std::size_t{1} << 16;
};

struct Shrunk {
    Input input;
    std::size_t rounds = 0, tried = 0; ///< candidates in all
};

/// `input` must fail. Deterministic: what is tried depends on the input and the answers alone.
Shrunk shrink(const Case& c, Input input, const StillFails& still_fails, const ShrinkOptions& options = {});

} // namespace gnomon::fuzz
