// Small changes to an input: what a hill is climbed by.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/random.h"

#include <cstdint>
#include <span>

namespace gnomon::worst {

/// Changes one to three things about `words`: a bit; a few ulps up or down, or many; the sign; the octave;
/// two words exchanged; a word as `other` has it; a place near a locus of the case's generator.
void change(const Case& c, Random& random, std::span<std::uint32_t> words,
            std::span<const std::uint32_t> other);

} // namespace gnomon::worst
