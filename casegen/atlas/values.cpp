#include "casegen/atlas/values.h"

#include "casegen/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace gnomon::atlas {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr Rgb unwritten_colour{192, 38, 211}, equal_colour{232, 234, 238}, allowed_colour{217, 142, 4},
    refused_colour{200, 24, 7}, undefined_colour{150, 155, 165};

/// The middle of cell `i` of `count`; exact for a power of two.
double middle(int i, int count) { return (i + 0.5) / count; }

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double part) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * part));
}
Rgb mixed(Rgb from, Rgb to, double part) {
    return {mixed(from.r, to.r, part), mixed(from.g, to.g, part), mixed(from.b, to.b, part)};
}

Rgb value_colour(const Case& c, double value) {
    if (std::isnan(value)) return unwritten_colour;
    const double range = c.result.upper - c.result.lower;
    const double part = range > 0 ? (value - c.result.lower) / range : 0;
    return mixed(shadow_colour, light_colour, std::clamp(part, 0.0, 1.0));
}

/// A parameter's value, by a fact or in place of one.
struct Told {
    bool by_mask = false;
    Numbers numbers{};
};
Told value_of(const Case& c, std::size_t parameter, const Facts& facts) {
    const auto components = static_cast<std::size_t>(c.reference.parameters[parameter].components);
    const Domain& domain = c.parameters[parameter].domain;
    Told told;
    if (const Fact fact = find_fact(c.parameters[parameter].name))
        told.by_mask = fact(facts, told.numbers) == static_cast<int>(components);
    for (std::size_t k = 0; !told.by_mask && k < components; ++k)
        told.numbers[k] = domain.choices.empty() ? domain.lower : domain.choices.front()[k];
    return told;
}

double result_of(const Case& c, const Outputs& outputs, std::size_t index) {
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    return outputs.unwritten[index] != 0
               ? nothing
               : widen(c.reference.result.scalar, outputs.words[index * components]);
}

} // namespace

std::vector<std::uint32_t> words_of(const Case& c, const Facts& facts) {
    std::vector<std::uint32_t> words;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Told told = value_of(c, i, facts);
        const Type type = c.reference.parameters[i];
        for (std::size_t k = 0; k < static_cast<std::size_t>(type.components); ++k)
            words.push_back(narrow(type.scalar, told.numbers[k]));
    }
    return words;
}

std::vector<std::string> untold(const Case& c, const Facts& facts) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Told told = value_of(c, i, facts);
        const auto components = static_cast<std::size_t>(c.reference.parameters[i].components);
        if (!told.by_mask)
            all.push_back(fmt::format("{} = {}", c.parameters[i].name,
                                      fmt::join(std::span(told.numbers).first(components), ",")));
    }
    return all;
}

Facts facts_of(const Witness& witness) {
    Facts facts;
    facts.texel = witness.texel;
    facts.p = {0.5, 0.5};
    facts.edge = reference::edge(witness.mask, witness.texel);
    facts.mask = &witness.mask;
    return facts;
}

Records value_records(const Case& c, const Witness& witness, int side) {
    Facts facts = facts_of(witness);
    Records records(c);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            facts.p = {middle(x, side), middle(y, side)};
            records.add(words_of(c, facts), &witness.mask);
        }
    return records;
}

ValueMap make_value_map(const Case& c, const Records& records, int side, const Outputs* outputs) {
    ValueMap map;
    map.side = side;
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Arguments with = arguments(c, records.input(i), records.mask(i));
        const bool defined = in_domain(c, with);
        map.want.push_back(defined ? c.reference.call(with)[0] : nothing);
        if (!outputs) continue;
        map.got.push_back(result_of(c, *outputs, i));
        const double difference = std::abs(map.got.back() - map.want.back());
        const bool passes =
            outputs->unwritten[i] == 0 &&
            judge(c, with, std::span(outputs->words).subspan(i * components, components)).pass;
        map.agreement.push_back(!passes           ? Agreement::refused
                                : !defined        ? Agreement::undefined
                                : difference == 0 ? Agreement::equal
                                                  : Agreement::allowed);
        if (!passes) ++map.refused;
        if (!defined || difference == 0) continue;
        ++map.differ;
        map.largest_difference =
            std::max(map.largest_difference,
                     std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference);
    }
    return map;
}

double difference_scale(const Case& c) {
    const double largest = std::max(std::abs(c.result.lower), std::abs(c.result.upper));
    switch (c.tolerance.kind) {
    case Tolerance::Kind::absolute:
        return c.tolerance.amount;
    case Tolerance::Kind::ulps: // of the largest result
        return c.tolerance.amount * largest * 0x1p-24;
    case Tolerance::Kind::exact:
        return largest * 0x1p-24;
    case Tolerance::Kind::input_within:
    case Tolerance::Kind::conditioned: // differs from input to input
        break;
    }
    return c.result.upper - c.result.lower;
}

Image values_image(const Case& c, const ValueMap& map, const std::vector<double>& values) {
    Image image(map.side, map.side);
    std::ranges::transform(values, image.pixels.begin(),
                           [&](double value) { return value_colour(c, value); });
    return image;
}

Image difference_image(const Case& c, const ValueMap& map) {
    Image image(map.side, map.side, equal_colour);
    const double scale = difference_scale(c);
    for (std::size_t i = 0; i < map.agreement.size(); ++i) {
        Rgb& pixel = image.pixels[i];
        switch (map.agreement[i]) {
        case Agreement::equal:
            break;
        case Agreement::allowed: // never so pale that it would be overlooked
            pixel = mixed(equal_colour, allowed_colour,
                          std::clamp(std::abs(map.got[i] - map.want[i]) / scale, 0.25, 1.0));
            break;
        case Agreement::refused:
            pixel = refused_colour;
            break;
        case Agreement::undefined:
            pixel = undefined_colour;
        }
    }
    return image;
}

void add_mask_records(Records& records, const Case& visibility, const Mask& mask, int scale) {
    const int width = (mask.width + 2) * scale, height = (mask.height + 2) * scale;
    Facts facts;
    facts.mask = &mask;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            facts.texel = {x / scale - 1, y / scale - 1};
            facts.p = {middle(x % scale, scale), middle(y % scale, scale)};
            records.add(words_of(visibility, facts), &mask);
        }
}

Image mask_image(const Case& visibility, const Mask& mask, int scale, const Outputs& outputs,
                 std::size_t first) {
    Image image((mask.width + 2) * scale, (mask.height + 2) * scale);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = value_colour(visibility, result_of(visibility, outputs, first + i));
    return image;
}

} // namespace gnomon::atlas
