// What a fuzzer runs a kernel on. Of sixteen inputs that begin a block nine are as check draws them (from
// masks, generators and domains), two of these with one or two boundary values put in, one is random bits,
// and four are changes of the worst ones found so far. The others of a block are its first one with one to
// three words drawn anew: that costs less than half of a draw, and reaches as far.
#pragma once

#include "casegen/fuzz/failure.h"
#include "casegen/sampling.h"
#include "casegen/worst/search.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
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

    /// Inputs `begin` to `end` of one block, the same as one by one, into rows that begin `stride` words
    /// apart.
    const Mask* draw_block(std::uint64_t begin, std::uint64_t end, const std::vector<worst::Row>& worst,
                           std::span<std::uint32_t> rows, std::size_t stride) const;

private:
    /// A way to draw a word anew, by k = (random bits >> before) * count >> after. Before and after are 11
    /// and 0 for 53 random bits, or 32 and 32 for 0 to count - 1.
    struct Way {
        /// In the order of drawn_anew's results; whole numbers, which are none of them, last.
        enum class Takes : std::uint8_t { real, counted, listed, whole } takes = Takes::real;
        std::uint8_t before = 11, after = 0;
        std::uint64_t count = 1;
        double unit = 0x1p-53;              ///< real, whole: k times this share of the range
        std::uint32_t kept = 0, offset = 0; ///< counted: (what stands there & kept) + offset + k
        std::uint32_t k_bits = 0;           ///< listed: all, for others none, which then read the first value
        std::uint32_t listed_at = 0;        ///< listed: value number k + listed_at
    };
    /// A word of the record, with all that drawing it anew asks for looked up once.
    struct Word {
        Scalar scalar = Scalar::float32;
        double lower = 0, extent = 0;      ///< real, whole: from where, and how far
        std::vector<std::uint32_t> values; ///< boundary values, one at least, then the domain's list
        std::size_t boundary_values = 0;
        std::vector<Way> ways;
        std::array<std::uint8_t, 128> way_of{}; ///< by seven random bits
    };
    static Word make_word(Scalar scalar, const Domain& domain, std::size_t component, bool is_texel);
    const Mask* draw_first(std::uint64_t index, const std::vector<worst::Row>& worst,
                           std::span<std::uint32_t> words) const;
    void vary(std::uint64_t index, std::span<std::uint32_t> words) const;
    static std::uint32_t drawn_anew(const Word& word, std::uint32_t now, std::uint64_t bits);

    const Case& case_;
    const Sampler& sampler_;
    Random::Streams beginnings_, variations_;
    std::size_t block_size_;
    std::vector<Word> words_;
};

} // namespace gnomon::fuzz
