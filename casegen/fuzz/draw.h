// What a fuzzer runs a kernel on. Of sixteen inputs that begin a block nine are as check draws them (from
// masks, generators and domains), two of these with one or two boundary values put in, one is random bits,
// and four are changes of the worst ones found so far. The others of a block are its first one with one to
// three words drawn anew: that costs a tenth of a draw, and reaches as far.
#pragma once

#include "casegen/fuzz/failure.h"
#include "casegen/sampling.h"
#include "casegen/worst/search.h"

#include <algorithm>
#include <array>
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

    /// Inputs in a block: 8; 1 of kernels with a generator, whose parameters depend on each other.
    std::size_t block_size() const { return block_size_; }

    /// Input `index`: writes the words, returns the mask. `worst`: rows found before this batch.
    const Mask* operator()(std::uint64_t index, const std::vector<worst::Row>& worst,
                           std::span<std::uint32_t> words) const;

    /// Inputs `begin` to `end` of one block, the same as one by one: `row(i)` is the words of input begin +
    /// i.
    template <typename Row>
    const Mask* draw_block(std::uint64_t begin, std::uint64_t end, const std::vector<worst::Row>& worst,
                           const Row& row) const {
        const std::uint64_t first = begin - begin % block_size_;
        std::array<std::uint32_t, 16> words;
        const std::span base = std::span(words).first(words_.size());
        const Mask* mask = draw_first(first, worst, base);
        for (std::uint64_t index = begin; index < end; ++index) {
            const std::span<std::uint32_t> to = row(index - begin);
            std::ranges::copy(base, to.begin());
            if (index != first) vary(index, to);
        }
        return mask;
    }

private:
    /// A word of the record, with all that drawing it anew asks for looked up once.
    struct Word {
        Scalar scalar;
        double lower, upper;
        bool is_texel;
        std::vector<std::uint32_t> choices, boundary;
    };
    const Mask* draw_first(std::uint64_t index, const std::vector<worst::Row>& worst,
                           std::span<std::uint32_t> words) const;
    void vary(std::uint64_t index, std::span<std::uint32_t> words) const;
    static std::uint32_t drawn_anew(const Word& word, std::uint32_t now, std::uint64_t bits);

    const Case& case_;
    const Sampler& sampler_;
    std::uint64_t seed_;
    std::size_t block_size_;
    std::vector<Word> words_;
};

} // namespace gnomon::fuzz
