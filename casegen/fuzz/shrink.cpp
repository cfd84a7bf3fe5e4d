#include "casegen/fuzz/shrink.h"

#include "casegen/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace gnomon::fuzz {
namespace {

// A texel weighs more than all digits, as the reader must draw it.
constexpr double texel_weight = 1e6, shadow_weight = 1e4, outside_weight = 1e3;

double float_complexity(float value) {
    if (std::isnan(value)) return 120;
    if (std::isinf(value)) return 110;
    if (value == 0) return std::signbit(value) ? 1 : 0;
    if (value == 1) return 0.5;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t mantissa = bits & 0x7fffffu;
    const int digits = mantissa == 0 ? 0 : 23 - std::countr_zero(mantissa);
    return 1.5 + 2 * digits + 0.25 * std::abs(std::ilogb(value)) + (value < 0 ? 0.5 : 0);
}

double whole_complexity(double value) {
    return value == 0 ? 0 : 1 + std::log2(std::abs(value)) + (value < 0 ? 0.5 : 0);
}

double word_complexity(Scalar scalar, std::uint32_t word) {
    return scalar == Scalar::float32 ? float_complexity(std::bit_cast<float>(word))
                                     : whole_complexity(widen(scalar, word));
}

/// Simpler values for one word, in the order of trial; some are not.
std::vector<std::uint32_t> simpler_words(Scalar scalar, const Domain& domain, std::size_t component,
                                         std::uint32_t word) {
    std::vector<std::uint32_t> words;
    const auto add = [&](double number) { words.push_back(narrow(scalar, number)); };
    for (const std::vector<double>& choice : domain.choices) add(choice[component]);
    if (scalar == Scalar::float32) {
        for (const double number : {0.0, 1.0, 0.5, -1.0, 0.25, 0.75, 2.0, -0.5, 0.125, 0.375, 0.625, 0.875,
                                    4.0, 10.0, domain.lower, domain.upper})
            add(number);
        for (int digits = 0; digits < 23; ++digits)
            for (const bool rounded : {false, true}) words.push_back(with_digits(word, digits, rounded));
        const float value = std::bit_cast<float>(word);
        if (std::isfinite(value)) {
            for (const float near : {std::trunc(value), std::round(value), -value, value * 0.5f, value * 2})
                words.push_back(std::bit_cast<std::uint32_t>(near));
            for (const float power : {0.0009765625f, 0.0078125f, 0.0625f, 16.0f, 128.0f, 1024.0f}) {
                words.push_back(std::bit_cast<std::uint32_t>(value * power));
            }
        }
        return words;
    }
    const double value = widen(scalar, word);
    for (const double number : {0.0, 1.0, -1.0, 2.0, 3.0, std::trunc(value / 2), value - 1, value + 1, -value,
                                std::trunc(value / 16)})
        if (scalar == Scalar::int32 ? std::abs(number) < 2147483648.0 : number >= 0) add(number);
    return words;
}

struct Word {
    Scalar scalar;
    const Domain* domain;
    std::size_t component;
};

std::vector<Word> words_of(const Case& c) {
    std::vector<Word> words;
    for (std::size_t i = 0; i < c.parameters.size(); ++i)
        for (int k = 0; k < c.reference.parameters[i].components; ++k)
            words.push_back(
                {c.reference.parameters[i].scalar, &c.parameters[i].domain, static_cast<std::size_t>(k)});
    return words;
}

/// The part of a mask from (x, y) on, with the texel that is asked about where it was in the picture.
Input cropped(const Case& c, const Input& input, int x, int y, int width, int height) {
    Input result = input;
    result.mask = Mask(width, height, true, input.mask.outside);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            result.mask.set(column, row, input.mask.lit(x + column, y + row));
    if (const std::size_t at = texel_word(c); at + 1 < input.words.size()) {
        const auto moved = [](std::uint32_t word, int by) {
            return std::bit_cast<std::uint32_t>(
                static_cast<std::int32_t>(word - static_cast<std::uint32_t>(by)));
        };
        result.words[at] = moved(input.words[at], x);
        result.words[at + 1] = moved(input.words[at + 1], y);
    }
    return result;
}

/// Without row or column `at`.
Input without(const Case& c, const Input& input, bool row, int at) {
    const Mask& mask = input.mask;
    Input result = input;
    result.mask = Mask(mask.width - (row ? 0 : 1), mask.height - (row ? 1 : 0), true, mask.outside);
    for (int y = 0; y < result.mask.height; ++y)
        for (int x = 0; x < result.mask.width; ++x)
            result.mask.set(x, y, mask.lit(!row && x >= at ? x + 1 : x, row && y >= at ? y + 1 : y));
    const std::size_t first = texel_word(c);
    if (const std::size_t word = first + (row ? 1 : 0); word < input.words.size()) {
        const auto texel = std::bit_cast<std::int32_t>(input.words[word]);
        if (texel > at) result.words[word] = std::bit_cast<std::uint32_t>(texel - 1);
    }
    return result;
}

void add_smaller_masks(const Case& c, const Input& input, std::vector<Input>& candidates) {
    const Mask& mask = input.mask;
    // Every small piece around the texel that is asked about.
    if (const std::size_t at = texel_word(c); at + 1 < input.words.size()) {
        const auto tx = std::bit_cast<std::int32_t>(input.words[at]);
        const auto ty = std::bit_cast<std::int32_t>(input.words[at + 1]);
        if (std::abs(tx) < 1 << 14 && std::abs(ty) < 1 << 14)
            for (int height = 1; height <= 4; ++height)
                for (int width = 1; width <= 4; ++width)
                    for (int y = ty - height; y <= ty + 1; ++y)
                        for (int x = tx - width; x <= tx + 1; ++x)
                            candidates.push_back(cropped(c, input, x, y, width, height));
    }
    for (int cut = 1; cut < mask.width; ++cut) {
        candidates.push_back(cropped(c, input, 0, 0, mask.width - cut, mask.height));
        candidates.push_back(cropped(c, input, cut, 0, mask.width - cut, mask.height));
    }
    for (int cut = 1; cut < mask.height; ++cut) {
        candidates.push_back(cropped(c, input, 0, 0, mask.width, mask.height - cut));
        candidates.push_back(cropped(c, input, 0, cut, mask.width, mask.height - cut));
    }
    if (mask.height > 1)
        for (int y = 0; y < mask.height; ++y) candidates.push_back(without(c, input, true, y));
    if (mask.width > 1)
        for (int x = 0; x < mask.width; ++x) candidates.push_back(without(c, input, false, x));
}

void add_simpler_masks(const Input& input, std::vector<Input>& candidates) {
    const Mask& mask = input.mask;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            candidates.push_back(input);
            candidates.back().mask.set(x, y, !mask.lit(x, y));
        }
    for (int y = 0; y < mask.height; ++y) { // a row, then a column, all lit
        candidates.push_back(input);
        for (int x = 0; x < mask.width; ++x) candidates.back().mask.set(x, y, true);
    }
    for (int x = 0; x < mask.width; ++x) {
        candidates.push_back(input);
        for (int y = 0; y < mask.height; ++y) candidates.back().mask.set(x, y, true);
    }
}

/// What lies outside decides what a small piece of a mask is seen in, so every one is tried in all three.
void add_surrounds(std::vector<Input>& candidates) {
    const std::size_t count = candidates.size();
    for (std::size_t i = 0; i < count; ++i)
        for (const Outside outside : {Outside::clamp, Outside::lit, Outside::shadow})
            if (outside != candidates[i].mask.outside) {
                candidates.push_back(candidates[i]);
                candidates.back().mask.outside = outside;
            }
}

void add_simpler_numbers(const Case& c, const Input& input, std::vector<Input>& candidates) {
    const std::vector<Word> words = words_of(c);
    const auto with = [&](std::size_t at, std::uint32_t word) {
        candidates.push_back(input);
        candidates.back().words[at] = word;
    };
    std::vector<std::vector<std::uint32_t>> simpler;
    for (std::size_t i = 0; i < words.size(); ++i) {
        simpler.push_back(
            simpler_words(words[i].scalar, *words[i].domain, words[i].component, input.words[i]));
        for (const std::uint32_t word : simpler.back()) with(i, word);
    }
    for (int digits = 0; digits < 23; ++digits) { // all at once
        candidates.push_back(input);
        for (std::size_t i = 0; i < words.size(); ++i)
            if (words[i].scalar == Scalar::float32)
                candidates.back().words[i] = with_digits(input.words[i], digits, true);
    }
    // Two at once: where a sum, or an order, must be kept.
    constexpr std::size_t firsts = 24;
    for (std::size_t a = 0; a < words.size(); ++a)
        for (std::size_t b = 0; b < words.size(); ++b) {
            if (a == b) continue;
            with(a, input.words[b]); // equal to the other
            if (b < a) continue;
            for (std::size_t m = 0; m < std::min(firsts, simpler[a].size()); ++m)
                for (std::size_t n = 0; n < std::min(firsts, simpler[b].size()); ++n) {
                    with(a, simpler[a][m]);
                    candidates.back().words[b] = simpler[b][n];
                }
        }
}

/// Any mask of at most 3x3 texels on which the kernel fails in the same way, at some points that know nothing
/// of the input's: where a run's length decides, mask and point must change together, which no small step
/// does. Nothing if there is none.
std::optional<Input> on_a_small_mask(const Case& c, const Input& input, const StillFails& still_fails,
                                     std::size_t at_once, Shrunk& result) {
    constexpr int side = 3, points = 24;
    const std::size_t texel = texel_word(c);
    const std::vector<Word> words = words_of(c);
    if (texel + 1 >= input.words.size()) return {};
    std::vector<glm::ivec2> sizes;
    for (int width = 1; width <= side; ++width)
        for (int height = 1; height <= side; ++height) sizes.emplace_back(width, height);
    std::ranges::stable_sort(sizes, {}, [](glm::ivec2 size) { return size.x * size.y; });
    Random random(hash(c.name)); // always the same points: what is found depends on the failure alone
    std::vector<Input> candidates;
    std::optional<Input> found;
    const auto ask = [&] {
        const std::vector<bool> fails = still_fails(candidates);
        result.tried += candidates.size();
        const auto first = std::ranges::find(fails, true);
        if (first != fails.end()) found = candidates[static_cast<std::size_t>(first - fails.begin())];
        candidates.clear();
    };
    const auto add_points = [&](const Mask& mask, int x, int y) {
        for (int n = 0; n < points; ++n) {
            candidates.push_back({input.words, mask});
            candidates.back().words[texel] = std::bit_cast<std::uint32_t>(x);
            candidates.back().words[texel + 1] = std::bit_cast<std::uint32_t>(y);
            for (std::size_t i = 0; i < words.size() && n > 0; ++i)
                if (words[i].scalar == Scalar::float32)
                    candidates.back().words[i] =
                        narrow(Scalar::float32,
                               words[i].domain->lower + (words[i].domain->upper - words[i].domain->lower) *
                                                            (random.between(0, 256) / 256.0));
        }
    };
    for (const glm::ivec2 size : sizes) {
        for (const Outside outside : {Outside::clamp, Outside::lit, Outside::shadow})
            for (std::uint32_t bits = 0; bits < 1u << (size.x * size.y); ++bits) {
                Mask mask(size.x, size.y, true, outside);
                for (std::size_t i = 0; i < mask.texels.size(); ++i)
                    mask.texels[i] = static_cast<std::uint8_t>(bits >> i & 1u);
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x) add_points(mask, x, y);
                if (candidates.size() >= at_once) ask();
                if (found) return found;
            }
        if (!candidates.empty()) ask();
        if (found) return found;
    }
    return {};
}

} // namespace

std::uint32_t with_digits(std::uint32_t word, int digits, bool rounded) {
    if (!std::isfinite(std::bit_cast<float>(word))) return word;
    const std::uint32_t dropped = (1u << (23 - digits)) - 1u;
    const std::uint32_t up = rounded ? (dropped + 1u) >> 1 : 0u; // a carry into the exponent is right
    const std::uint32_t result = (word + up) & ~dropped;
    return std::isfinite(std::bit_cast<float>(result)) ? result : word;
}

double complexity(const Case& c, const Input& input) {
    double sum = 0;
    if (c.reference.takes_mask) {
        const auto texels = static_cast<double>(input.mask.texels.size());
        const auto lit = static_cast<double>(std::ranges::count(input.mask.texels, 1));
        sum += texel_weight * texels + shadow_weight * (texels - lit) +
               outside_weight * static_cast<double>(input.mask.outside);
    }
    for (std::size_t i = 0; i < input.words.size(); ++i)
        sum += word_complexity(c.reference.words[i], input.words[i]);
    return sum;
}

Shrunk shrink(const Case& c, Input input, const StillFails& still_fails, const ShrinkOptions& options) {
    Shrunk result{std::move(input), 0, 0};
    if (c.reference.takes_mask && result.input.mask.texels.size() > 9 && options.small_masks_at_once > 0)
        if (auto small = on_a_small_mask(c, result.input, still_fails, options.small_masks_at_once, result))
            result.input = std::move(*small);
    double least = complexity(c, result.input);
    std::size_t fruitless = 0;
    for (; result.rounds < options.rounds; ++result.rounds) {
        std::vector<Input> candidates;
        if (c.reference.takes_mask) {
            add_smaller_masks(c, result.input, candidates);
            add_simpler_masks(result.input, candidates);
            candidates.push_back(result.input);
            add_surrounds(candidates);
        }
        add_simpler_numbers(c, result.input, candidates);

        // Simplest first: of those that fail the first is the one, and the last are the ones to do without.
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (const double of = complexity(c, candidates[i]); of < least) order.emplace_back(of, i);
        if (order.empty()) break;
        std::ranges::sort(order);
        std::vector<Input> tried;
        // Where there are too many, some of all degrees: the simplest alone may all be too simple.
        const std::size_t stride = (order.size() + options.candidates - 1) / options.candidates;
        for (std::size_t i = result.rounds % stride; i < order.size(); i += stride)
            tried.push_back(std::move(candidates[order[i].second]));
        const std::vector<bool> fails = still_fails(tried);
        result.tried += tried.size();
        const auto first = std::ranges::find(fails, true);
        if (first == fails.end()) {
            if (++fruitless < stride) continue; // there are others
            break;
        }
        fruitless = 0;
        result.input = std::move(tried[static_cast<std::size_t>(first - fails.begin())]);
        least = complexity(c, result.input);
    }
    return result;
}

} // namespace gnomon::fuzz
