// What a fuzzer runs a kernel on. Of sixteen inputs nine are as check draws them (from masks, generators and
// domains), two of these with one or two boundary values put in, one is random bits, and four are changes of
// the worst ones found so far.
#pragma once

#include "casegen/fuzz/failure.h"
#include "casegen/sampling.h"
#include "casegen/worst/search.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace gnomon::fuzz {

/// Masks for the units of one epoch: of all families at sizes from 8 to 48, or very small ones of any bits
/// and proportions, which no family holds.
std::shared_ptr<const EdgePool> make_fuzz_pool(std::uint64_t seed, std::uint64_t epoch);

/// Draws one unit's inputs.
class Draw {
public:
    /// The kernel, masks and fixed samples of `sampler`, with a seed of its own.
    Draw(const Case& c, const Sampler& sampler, std::uint64_t seed);

    /// Input `index`: writes the words, returns the mask. `worst`: rows found before this batch.
    const Mask* operator()(std::uint64_t index, const std::vector<worst::Row>& worst,
                           std::span<std::uint32_t> words) const;

private:
    const Case& case_;
    const Sampler& sampler_;
    std::uint64_t seed_;
    std::vector<std::vector<std::uint32_t>> boundary_; ///< values per word
};

} // namespace gnomon::fuzz
