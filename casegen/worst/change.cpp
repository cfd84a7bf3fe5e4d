#include "casegen/worst/change.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace gnomon::worst {
namespace {

/// Floats in the order of their values, as whole numbers, so that steps cross zero.
std::uint32_t moved_by(std::uint32_t word, std::int64_t ulps) {
    const auto bits = std::bit_cast<std::int32_t>(word);
    constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();
    const std::int64_t at = (bits >= 0 ? bits : least - bits) + ulps;
    constexpr std::int64_t infinity = 0x7f800000;
    const std::int64_t kept = std::clamp(at, -infinity, infinity);
    return std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(kept >= 0 ? kept : least - kept));
}

std::uint32_t changed_float(Random& random, std::uint32_t word) {
    const float value = std::bit_cast<float>(word);
    switch (random.below(6)) {
    case 0: // a bit of the mantissa
        return word ^ 1u << random.below(23);
    case 1:
        return moved_by(word, random.chance(0.5) ? 1 : -1);
    case 2: { // many ulps, each order of magnitude as likely
        const std::int64_t ulps = std::int64_t{1} << random.below(24);
        return moved_by(word, random.chance(0.5) ? ulps : -ulps);
    }
    case 3:
        return word ^ 0x80000000u;
    case 4:
        return std::bit_cast<std::uint32_t>(std::ldexp(value, random.between(-4, 4)));
    default: // a rounder number: its low bits cleared
        return word & ~((1u << random.below(24)) - 1u);
    }
}

std::uint32_t changed_whole(Random& random, Scalar scalar, std::uint32_t word) {
    if (scalar == Scalar::boolean) return word == 0 ? 1u : 0u;
    return random.chance(0.5) ? word ^ 1u << random.below(6) : word + (random.chance(0.5) ? 1u : 0xffffffffu);
}

void move_to_locus(const Case& c, Random& random, std::span<std::uint32_t> words) {
    const std::vector<Locus>& loci = c.generator->loci;
    std::array<double, 16> numbers{};
    const std::span used = std::span(numbers).first(words.size());
    for (std::size_t i = 0; i < words.size(); ++i) used[i] = widen(c.reference.words[i], words[i]);
    const Locus& locus = loci[random.below(static_cast<std::uint32_t>(loci.size()))];
    locus.place(random, locus_distance(random.between(0, locus_distances - 1)), used);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = narrow(c.reference.words[i], used[i]);
}

} // namespace

void change(const Case& c, Random& random, std::span<std::uint32_t> words,
            std::span<const std::uint32_t> other) {
    if (words.empty()) return;
    const auto any = [&] { return random.below(static_cast<std::uint32_t>(words.size())); };
    const std::vector<Scalar>& scalars = c.reference.words;
    for (int times = random.between(1, 3); times > 0; --times) {
        const std::uint32_t at = any(), choice = random.below(16);
        if (choice == 0) {
            const std::uint32_t with = any();
            if (scalars[at] == scalars[with]) std::swap(words[at], words[with]);
        } else if (choice <= 2) {
            words[at] = other[at];
        } else if (choice == 3 && c.generator && !c.generator->loci.empty()) {
            move_to_locus(c, random, words);
        } else {
            words[at] = scalars[at] == Scalar::float32 ? changed_float(random, words[at])
                                                       : changed_whole(random, scalars[at], words[at]);
        }
    }
}

} // namespace gnomon::worst
