#include "casegen/sampling.h"

#include "casegen/mask_families.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

constexpr int mask_size = 32;
constexpr int members_per_family = 6;
constexpr std::size_t most_combinations = 4096;

/// A float in [lower, upper]: half of them uniform; a quarter over bit patterns, so that every decade has its
/// share; a quarter multiples of a power of two, where ties and cancellations live. All from one draw of 64
/// bits.
double draw_float(Random& random, double lower, double upper) {
    const std::uint64_t bits = random.bits();
    const std::uint64_t choice = bits & 3, fraction = bits >> 11; // 53 bits
    // All three are drawn: which of them is taken a processor would mostly guess wrongly, which costs it
    // more.
    const double unit = to_double(fraction) * 0x1p-53;
    const auto drawn = static_cast<double>(static_cast<float>(lower + (upper - lower) * unit));
    const double uniform = std::clamp(drawn, lower, upper); // rounding to float may leave the interval
    double pattern = uniform;
    if (lower >= 0 && upper > lower) { // patterns are ordered for positive numbers only
        const auto low = std::bit_cast<std::uint32_t>(static_cast<float>(lower));
        const auto high = std::bit_cast<std::uint32_t>(static_cast<float>(upper));
        pattern = static_cast<double>(std::bit_cast<float>(
            static_cast<std::uint32_t>(low + fraction % (std::uint64_t{high} - low + 1))));
    }
    const std::uint64_t steps = std::uint64_t{1} << ((bits >> 2) % 9); // 1 … 256
    const double tie = lower + (upper - lower) * to_double(fraction % (steps + 1)) / to_double(steps);
    const std::array drawn_by_choice{uniform, uniform, pattern, tie};
    return drawn_by_choice[choice];
}

} // namespace

std::vector<std::uint32_t> hostile_words(Scalar scalar, const Domain& domain, std::size_t component) {
    std::vector<std::uint32_t> words;
    const auto add = [&](double number) { words.push_back(narrow(scalar, number)); };
    for (const std::vector<double>& choice : domain.choices) add(choice[component]);
    switch (scalar) {
    case Scalar::float32: {
        const auto lower = static_cast<float>(domain.lower), upper = static_cast<float>(domain.upper);
        const float infinity = std::numeric_limits<float>::infinity();
        for (const float v : {lower, upper, std::nextafter(lower, infinity), std::nextafter(upper, -infinity),
                              std::nextafter(lower, -infinity), std::nextafter(upper, infinity),
                              0.5f * (lower + upper), 0.0f, -0.0f, FLT_TRUE_MIN, FLT_MIN, FLT_MAX, -FLT_MAX,
                              infinity, -infinity, std::bit_cast<float>(0x7fffffffu)}) // NaN of all bits
            words.push_back(std::bit_cast<std::uint32_t>(v));
        break;
    }
    case Scalar::int32:
        for (const double v :
             {domain.lower, domain.upper, domain.lower - 1, domain.upper + 1, 0.0, 1.0, -1.0})
            add(v);
        break;
    case Scalar::uint32:
        for (const double v : {domain.lower, domain.upper, domain.upper + 1}) add(v);
        words.push_back(0xffffffffu);
        break;
    case Scalar::boolean:
        words = {0u, 1u};
        break;
    }
    std::ranges::sort(words);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

EdgePool make_edge_pool(std::uint64_t seed) {
    std::vector<Mask> masks;
    for (NamedMask& named : mask_corpus(seed, members_per_family, mask_size))
        masks.push_back(std::move(named.mask));
    return edge_pool_of(std::move(masks));
}

EdgePool edge_pool_of(std::vector<Mask> masks) {
    EdgePool pool;
    for (std::size_t n = 0; n < masks.size(); ++n) {
        const Mask& mask = masks[n];
        pool.side = std::max({pool.side, mask.width, mask.height});
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x)
                if (reference::discontinuity(mask, {x, y}) != glm::uvec2(0)) {
                    const reference::Edge edge = reference::edge(mask, {x, y});
                    pool.entries.push_back({static_cast<std::uint16_t>(n), glm::i8vec2(x, y),
                                            glm::u8vec2(edge.sides), glm::i8vec4(edge.reach),
                                            glm::i8vec2(edge.type), edge.dominant, edge.lit});
                }
    }
    pool.masks = std::move(masks);
    return pool;
}

Sampler::Sampler(const Case& c, std::uint64_t seed, std::shared_ptr<const EdgePool> pool,
                 const std::filesystem::path& pins, const std::filesystem::path& worst,
                 std::span<const CsvInput> regressions)
    : case_(c), seed_(seed), pool_(std::move(pool)) {
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Parameter& parameter = c.parameters[i];
        slots_.push_back({c.reference.parameters[i], &parameter.domain, find_fact(parameter.name),
                          parameter.name == "texel"});
    }
    for (std::uint32_t i = 0; i < pool_->entries.size(); ++i) {
        const EdgePool::Entry& entry = pool_->entries[i];
        if (applies(case_, entry.edge())) chosen_.push_back(i);
    }
    const auto pin = [&](const CsvInput& row) {
        pinned_.push_back(row.words);
        if (c.reference.takes_mask) pinned_masks_.push_back(row.mask);
    };
    std::ranges::for_each(regressions, pin);
    for (const std::filesystem::path& file : {worst, pins})
        if (!file.empty() && std::filesystem::exists(file)) std::ranges::for_each(read_inputs(c, file), pin);
    make_hostile();
}

/// Every combination of every component's hostile values if these are few; else each of them amid ordinary
/// ones, then combinations at random.
void Sampler::make_hostile() {
    std::vector<std::vector<std::uint32_t>> values;
    std::size_t combinations = 1;
    for (std::size_t i = 0; i < case_.parameters.size(); ++i) {
        const Type type = case_.reference.parameters[i];
        for (int k = 0; k < type.components; ++k) {
            values.push_back(
                hostile_words(type.scalar, case_.parameters[i].domain, static_cast<std::size_t>(k)));
            combinations = std::min(combinations * values.back().size(), most_combinations + 1);
        }
    }
    if (combinations <= most_combinations) {
        for (std::size_t n = 0; n < combinations; ++n) {
            std::vector<std::uint32_t> words;
            std::size_t rest = n;
            for (const std::vector<std::uint32_t>& of_component : values) {
                words.push_back(of_component[rest % of_component.size()]);
                rest /= of_component.size();
            }
            hostile_.push_back(std::move(words));
        }
        return;
    }
    Random random(seed_, ~std::uint64_t{0});
    for (std::size_t component = 0; component < values.size(); ++component)
        for (const std::uint32_t value : values[component])
            for (int repeat = 0; repeat < 8; ++repeat) {
                std::vector<std::uint32_t> words(values.size());
                if (case_.generator)
                    draw_generated(case_, random, {}, words);
                else
                    draw_abstract(random, words);
                words[component] = value;
                hostile_.push_back(std::move(words));
            }
    for (std::size_t n = 0; n < most_combinations / 2; ++n) {
        std::vector<std::uint32_t> words;
        for (const std::vector<std::uint32_t>& of_component : values)
            words.push_back(of_component[random.below(static_cast<std::uint32_t>(of_component.size()))]);
        hostile_.push_back(std::move(words));
    }
}

Sampler::Sample Sampler::draw(std::size_t index) const {
    Sample sample;
    sample.words.resize(word_count(case_));
    sample.mask = draw(index, sample.words);
    return sample;
}

const Mask* Sampler::draw(std::size_t index, std::span<std::uint32_t> words) const {
    if (index < pinned_.size()) {
        std::ranges::copy(pinned_[index], words.begin());
        return case_.reference.takes_mask ? &pinned_masks_[index] : nullptr;
    }
    // Samples are the same whatever rows stand before them, and those of one generator whatever a kernel's
    // own hostile values are.
    const std::size_t stream = index - (case_.generator ? first_stiff() : pinned_.size());
    Random random(seed_, stream);
    std::uint32_t mask = 0;
    if (const std::optional<Place> stiff = place(index)) {
        draw_generated(case_, random, stiff, words);
    } else if (index < fixed_count()) {
        std::ranges::copy(hostile_[index - pinned_.size()], words.begin());
        mask = random.below(static_cast<std::uint32_t>(pool_->masks.size()));
    } else if (case_.generator && stream % 4 != 3) {
        // Of four: two ordinary, one near a locus, and, below, one with components that know nothing of each
        // other.
        const auto loci = static_cast<std::uint32_t>(case_.generator->loci.size());
        std::optional<Place> near;
        if (stream % 4 == 2 && loci > 0)
            near = Place{random.below(loci), random.between(0, locus_distances - 1)};
        draw_generated(case_, random, near, words);
    } else if (stream % 2 == 1 && !chosen_.empty()) {
        mask = draw_from_mask(random, words);
    } else {
        mask = draw_abstract(random, words);
    }
    return case_.reference.takes_mask ? &pool_->masks[mask] : nullptr;
}

std::optional<Place> Sampler::place(std::size_t index) const {
    if (index < first_stiff() || index >= fixed_count()) return {};
    const std::size_t stiff = (index - first_stiff()) / stiff_repeats;
    return Place{stiff / locus_distances, static_cast<int>(stiff % locus_distances)};
}

void draw_generated(const Case& c, Random& random, const std::optional<Place>& place,
                    std::span<std::uint32_t> words) {
    std::array<double, 16> numbers{};
    const std::span used = std::span(numbers).first(words.size());
    c.generator->draw(random, used);
    if (place) c.generator->loci[place->locus].place(random, locus_distance(place->step), used);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = narrow(c.reference.words[i], used[i]);
}

void Sampler::draw_slot(Random& random, const Slot& slot, std::span<std::uint32_t> words) const {
    const Domain& domain = *slot.domain;
    const auto components = static_cast<std::size_t>(slot.type.components);
    if (!domain.choices.empty()) {
        const auto& choice = domain.choices[random.below(static_cast<std::uint32_t>(domain.choices.size()))];
        for (std::size_t k = 0; k < components; ++k) words[k] = narrow(slot.type.scalar, choice[k]);
        return;
    }
    for (std::size_t k = 0; k < components; ++k) {
        double number = 0;
        if (slot.is_texel)
            number = random.between(-2, pool_->side + 1);
        else if (slot.type.scalar == Scalar::float32)
            number = draw_float(random, domain.lower, domain.upper);
        else
            number = random.between(static_cast<int>(domain.lower), static_cast<int>(domain.upper));
        words[k] = narrow(slot.type.scalar, number);
    }
}

std::uint32_t Sampler::draw_abstract(Random& random, std::span<std::uint32_t> words) const {
    for (const Slot& slot : slots_) {
        draw_slot(random, slot, words);
        words = words.subspan(static_cast<std::size_t>(slot.type.components));
    }
    return random.below(static_cast<std::uint32_t>(pool_->masks.size()));
}

std::uint32_t Sampler::draw_from_mask(Random& random, std::span<std::uint32_t> words) const {
    const EdgePool::Entry& entry =
        pool_->entries[chosen_[random.below(static_cast<std::uint32_t>(chosen_.size()))]];
    Facts facts;
    facts.texel = glm::ivec2(entry.texel);
    facts.p.x = draw_float(random, 0, 1);
    facts.p.y = draw_float(random, 0, 1);
    facts.edge = entry.edge();
    facts.mask = &pool_->masks[entry.mask];
    facts.along_y = random.chance(0.5);
    for (const Slot& slot : slots_) {
        Numbers numbers{};
        const int known = slot.fact ? slot.fact(facts, numbers) : 0;
        // Another family may mean something else, of another size, by a fact's name.
        const bool meant = known == slot.type.components;
        if (!meant) draw_slot(random, slot, words);
        for (int k = 0; meant && k < known; ++k)
            words[static_cast<std::size_t>(k)] =
                narrow(slot.type.scalar, numbers[static_cast<std::size_t>(k)]);
        words = words.subspan(static_cast<std::size_t>(slot.type.components));
    }
    return entry.mask;
}

} // namespace gnomon
