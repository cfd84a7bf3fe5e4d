#include "casegen/fuzz/draw.h"

#include "casegen/mask_families.h"
#include "casegen/worst/change.h"

#include <array>

namespace gnomon::fuzz {
namespace {

Mask tiny_mask(Random& random) {
    const int width = random.between(1, 6), height = random.between(1, 6);
    const double density = random.chance(0.5) ? 0.5 : random.unit();
    Mask mask(width, height, true, static_cast<Outside>(random.below(3)));
    for (std::uint8_t& texel : mask.texels) texel = random.chance(density) ? 0 : 1;
    return mask;
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
    : case_(c), sampler_(sampler), seed_(seed) {
    for (std::size_t i = 0; i < c.parameters.size(); ++i)
        for (int k = 0; k < c.reference.parameters[i].components; ++k)
            boundary_.push_back(hostile_words(c.reference.parameters[i].scalar, c.parameters[i].domain,
                                              static_cast<std::size_t>(k)));
}

const Mask* Draw::operator()(std::uint64_t index, const std::vector<worst::Row>& worst,
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
            const std::vector<std::uint32_t>& values = boundary_[at];
            words[at] = values[random.below(static_cast<std::uint32_t>(values.size()))];
        }
    }
    return mask;
}

} // namespace gnomon::fuzz
