#include "casegen/fuzz/draw.h"

#include "casegen/mask_families.h"
#include "casegen/worst/change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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
    : case_(c), sampler_(sampler), beginnings_(seed), variations_(seed ^ hash("variations")),
      block_size_(c.generator ? 1 : 8) {
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Scalar scalar = c.reference.parameters[i].scalar;
        const Domain& domain = c.parameters[i].domain;
        for (int k = 0; k < c.reference.parameters[i].components; ++k) {
            const auto component = static_cast<std::size_t>(k);
            words_.push_back(make_word(scalar, domain, component, c.parameters[i].name == "texel"));
        }
    }
}

const Mask* Draw::operator()(std::uint64_t index, const std::vector<worst::Row>& worst,
                             std::span<std::uint32_t> words) const {
    return draw_block(index, index + 1, worst, words, words.size());
}

const Mask* Draw::draw_block(std::uint64_t begin, std::uint64_t end, const std::vector<worst::Row>& worst,
                             std::span<std::uint32_t> rows, std::size_t stride) const {
    const std::uint64_t first = begin - begin % block_size_;
    std::array<std::uint32_t, 16> words;
    const std::span base = std::span(words).first(words_.size());
    const Mask* mask = draw_first(first, worst, base);
    for (std::uint64_t index = begin; index < end; ++index) {
        const std::span<std::uint32_t> row = rows.subspan((index - begin) * stride, words_.size());
        std::ranges::copy(base, row.begin());
        if (index != first) vary(index, row);
    }
    return mask;
}

const Mask* Draw::draw_first(std::uint64_t index, const std::vector<worst::Row>& worst,
                             std::span<std::uint32_t> words) const {
    Random random = beginnings_[index];
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
            const std::span values = std::span(words_[at].values).first(words_[at].boundary_values);
            words[at] = values[random.below(static_cast<std::uint32_t>(values.size()))];
        }
    }
    return mask;
}

void Draw::vary(std::uint64_t index, std::span<std::uint32_t> words) const {
    if (words.empty()) return;
    Random random = variations_[index];
    const std::uint64_t which = random.bits();
    const std::uint64_t times = 1 + (which & 0xffff) * 3 / 0x10000;
    for (std::uint64_t n = 0; n < times; ++n) {
        const std::size_t at = (which >> (16 + 16 * n) & 0xffff) * words.size() / 0x10000;
        words[at] = drawn_anew(words_[at], words[at], random.bits());
    }
}

Draw::Word Draw::make_word(Scalar scalar, const Domain& domain, std::size_t component, bool is_texel) {
    using Takes = Way::Takes;
    Word word{.scalar = scalar, .lower = domain.lower, .extent = domain.upper - domain.lower};
    word.values = hostile_words(scalar, domain, component);
    word.boundary_values = word.values.size();
    for (const std::vector<double>& choice : domain.choices)
        word.values.push_back(narrow(scalar, choice[component]));

    constexpr std::uint32_t all = ~0u;
    const auto way = [](Takes takes, std::uint64_t count) { // k from 0 to count - 1
        return Way{.takes = takes, .before = 32, .after = 32, .count = count};
    };
    const auto counted = [&](std::uint32_t kept, std::uint32_t offset, std::uint64_t count) {
        Way made = way(Takes::counted, count);
        made.kept = kept;
        made.offset = offset;
        return made;
    };
    const auto listed = [&](std::size_t begin, std::size_t end) {
        Way made = way(Takes::listed, end - begin);
        made.k_bits = all;
        made.listed_at = static_cast<std::uint32_t>(begin);
        return made;
    };
    // Instead of what was added before, in the draws `first` to `last` of sixteen, or in an eighth of those.
    const auto add = [&](std::size_t first, std::size_t last, const Way& added,
                         std::optional<std::size_t> eighth = {}) {
        for (std::size_t i = 0; i < word.way_of.size(); ++i)
            if (i % 16 >= first && i % 16 <= last && i / 16 == eighth.value_or(i / 16))
                word.way_of[i] = static_cast<std::uint8_t>(word.ways.size());
        word.ways.push_back(added);
    };
    if (!domain.choices.empty()) {
        add(0, 15, listed(word.boundary_values, word.values.size()));
    } else if (is_texel && scalar != Scalar::float32) {
        add(0, 15, counted(all, 0u - 4, 9)); // up to 4 away; wraps
    } else if (scalar != Scalar::float32) {
        add(0, 15, {.takes = Takes::whole});
        word.extent += 1;
    } else {
        add(0, 15, {.takes = Takes::real});
        add(1, 1, counted(0, 0, std::uint64_t{1} << 32));       // any bits
        add(2, 2, counted(all, 0u - 8, 17));                    // some ulps away
        if (domain.lower >= 0 && domain.upper > domain.lower) { // patterns rise for positive numbers only
            const std::uint32_t low = narrow(scalar, domain.lower), high = narrow(scalar, domain.upper);
            add(3, 4, counted(0, low, std::uint64_t{high - low} + 1));
        }
        for (std::size_t eighth = 0; eighth < 8; ++eighth) { // where ties are: multiples of a power of two
            const std::uint64_t parts = std::uint64_t{1} << eighth;
            Way tie = way(Takes::real, parts + 1);
            tie.unit = 1 / static_cast<double>(parts);
            add(5, 7, tie, eighth);
        }
    }
    add(0, 0, listed(0, word.boundary_values));
    return word;
}

/// Computes all that a way may ask for and takes one: a processor cannot guess which, and a wrong guess costs
/// it more than all of them. Only whole numbers branch, whose words take that way nearly always.
std::uint32_t Draw::drawn_anew(const Word& word, std::uint32_t now, std::uint64_t bits) {
    const Way& way = word.ways[word.way_of[bits % 128]];
    const std::uint64_t k = (bits >> way.before) * way.count >> way.after;
    const double number = word.lower + word.extent * (to_double(k) * way.unit);
    if (way.takes == Way::Takes::whole) return narrow(word.scalar, std::floor(number));
    const std::array results{narrow(Scalar::float32, number),
                             (now & way.kept) + way.offset + static_cast<std::uint32_t>(k),
                             word.values[(k & way.k_bits) + way.listed_at]};
    static_assert(results.size() == static_cast<std::size_t>(Way::Takes::whole));
    return results[static_cast<std::size_t>(way.takes)];
}

} // namespace gnomon::fuzz
