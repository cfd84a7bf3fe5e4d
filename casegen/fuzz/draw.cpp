#include "casegen/fuzz/draw.h"

#include "casegen/mask_families.h"
#include "casegen/worst/change.h"

#include <array>
#include <cmath>

namespace gnomon::fuzz {
namespace {

Mask tiny_mask(Random& random) {
    const int width = random.between(1, 6), height = random.between(1, 6);
    const double density = random.chance(0.5) ? 0.5 : random.unit();
    Mask mask(width, height, true, static_cast<Outside>(random.below(3)));
    for (std::uint8_t& texel : mask.texels) texel = random.chance(density) ? 0 : 1;
    return mask;
}

/// One of a list, by the upper half of random bits.
std::uint32_t pick(const std::vector<std::uint32_t>& list, std::uint64_t bits) {
    return list[static_cast<std::size_t>((bits >> 32) * list.size() >> 32)];
}

} // namespace

std::shared_ptr<const EdgePool> make_fuzz_pool(std::uint64_t seed, std::uint64_t epoch) {
    constexpr std::array sizes{32, 8, 12, 48, 16, 9};
    Random random(seed ^ hash("masks"), epoch);
    std::vector<Mask> masks;
    if (epoch % 2 == 0) {
        const int size = sizes[epoch / 2 % sizes.size()];
        for (NamedMask& named : mask_corpus(random.bits(), 4, size)) masks.push_back(std::move(named.mask));
    } else {
        for (int i = 0; i < 512; ++i) masks.push_back(tiny_mask(random));
    }
    return std::make_shared<const EdgePool>(edge_pool_of(std::move(masks)));
}

Draw::Draw(const Case& c, const Sampler& sampler, std::uint64_t seed)
    : case_(c), sampler_(sampler), seed_(seed), block_size_(c.generator ? 1 : 8) {
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Scalar scalar = c.reference.parameters[i].scalar;
        const Domain& domain = c.parameters[i].domain;
        for (int k = 0; k < c.reference.parameters[i].components; ++k) {
            const auto component = static_cast<std::size_t>(k);
            Word word{scalar, domain.lower, domain.upper, c.parameters[i].name == "texel", {}, {}};
            for (const std::vector<double>& choice : domain.choices)
                word.choices.push_back(narrow(scalar, choice[component]));
            word.boundary = hostile_words(scalar, domain, component);
            words_.push_back(std::move(word));
        }
    }
}

const Mask* Draw::operator()(std::uint64_t index, const std::vector<worst::Row>& worst,
                             std::span<std::uint32_t> words) const {
    return draw_block(index, index + 1, worst, [&](std::uint64_t) { return words; });
}

const Mask* Draw::draw_first(std::uint64_t index, const std::vector<worst::Row>& worst,
                             std::span<std::uint32_t> words) const {
    Random random(seed_, index);
    const std::uint64_t bits = random.bits();
    const std::uint64_t choice = bits & 15;
    if (choice < 4 && !worst.empty()) {
        const auto pick = [&]() -> const worst::Row& { // the worse the likelier
            const double u = random.unit();
            return worst[static_cast<std::size_t>(u * u * static_cast<double>(worst.size()))];
        };
        const worst::Row& row = pick();
        std::ranges::copy(row.words, words.begin());
        worst::change(case_, random, words, pick().words);
        return row.mask;
    }
    const Mask* mask = sampler_.draw(sampler_.fixed_count() + static_cast<std::size_t>(index), words);
    if (choice == 4) {
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] = case_.reference.words[i] == Scalar::boolean
                           ? static_cast<std::uint32_t>(random.bits() & 1)
                           : static_cast<std::uint32_t>(random.bits() >> 32);
    } else if (choice <= 6 && !words.empty()) {
        for (int times = random.between(1, 2); times > 0; --times) {
            const std::uint32_t at = random.below(static_cast<std::uint32_t>(words.size()));
            const std::vector<std::uint32_t>& values = words_[at].boundary;
            words[at] = values[random.below(static_cast<std::uint32_t>(values.size()))];
        }
    }
    return mask;
}

void Draw::vary(std::uint64_t index, std::span<std::uint32_t> words) const {
    if (words.empty()) return;
    constexpr std::uint64_t stream = hash("variations");
    Random random(seed_ ^ stream, index);
    const std::uint64_t which = random.bits();
    const std::uint64_t times = 1 + (which & 0xffff) * 3 / 0x10000;
    for (std::uint64_t n = 0; n < times; ++n) {
        const std::size_t at = (which >> (16 + 16 * n) & 0xffff) * words.size() / 0x10000;
        words[at] = drawn_anew(words_[at], words[at], random.bits());
    }
}

std::uint32_t Draw::drawn_anew(const Word& word, std::uint32_t now, std::uint64_t bits) {
    const std::uint64_t kind = bits & 15;
    if (kind == 0) return pick(word.boundary, bits);
    if (!word.choices.empty()) return pick(word.choices, bits);
    const double share = static_cast<double>(bits >> 11) * 0x1p-53;
    if (word.scalar != Scalar::float32) {
        if (word.is_texel) return now + static_cast<std::uint32_t>((bits >> 32) * 9 >> 32) - 4; // wraps
        return narrow(word.scalar, std::floor(word.lower + share * (word.upper - word.lower + 1)));
    }
    switch (kind) {
    case 1:
        return static_cast<std::uint32_t>(bits >> 32);
    case 2: // a few ulps away
        return now + static_cast<std::uint32_t>((bits >> 32) * 17 >> 32) - 8;
    case 3:
    case 4: { // patterns are ordered for positive numbers only
        if (!(word.lower >= 0 && word.upper > word.lower)) break;
        const std::uint32_t low = narrow(Scalar::float32, word.lower),
                            high = narrow(Scalar::float32, word.upper);
        return low + static_cast<std::uint32_t>((bits >> 32) * (std::uint64_t{high - low} + 1) >> 32);
    }
    case 5:
    case 6:
    case 7: { // where ties are: multiples of a power of two of the range
        const std::uint64_t steps = std::uint64_t{1} << (bits >> 4 & 7);
        const std::uint64_t step = (bits >> 32) * (steps + 1) >> 32;
        return narrow(Scalar::float32, word.lower + (word.upper - word.lower) * static_cast<double>(step) /
                                                        static_cast<double>(steps));
    }
    default:
        break;
    }
    return narrow(Scalar::float32, word.lower + (word.upper - word.lower) * share);
}

} // namespace gnomon::fuzz
