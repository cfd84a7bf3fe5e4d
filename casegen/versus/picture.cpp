#include "casegen/versus/picture.h"

#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace gnomon::versus {
namespace {

constexpr double palest = 0.25; // of full colour: no difference is overlooked
constexpr int most_values = 256;

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double part) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * part));
}
Rgb mixed(Rgb from, Rgb to, double part) {
    return {mixed(from.r, to.r, part), mixed(from.g, to.g, part), mixed(from.b, to.b, part)};
}

bool is_continuous(const Case& c, const Component& component) {
    const Domain& domain = c.parameters[component.parameter].domain;
    return component.scalar == Scalar::float32 && domain.choices.empty() && domain.lower < domain.upper;
}

/// Whole numbers of a range as bands; a long one is thinned out.
std::vector<double> whole_numbers(double from, double to) {
    const double step = std::max(1.0, std::ceil((to - from + 1) / most_values));
    std::vector<double> values;
    for (double value = std::ceil(from); value <= to; value += step) values.push_back(value);
    return values;
}

Axis axis_along(const Case& c, std::size_t word, const Component& component) {
    const Domain& domain = c.parameters[component.parameter].domain;
    Axis axis;
    axis.word = word;
    axis.name = component.name;
    axis.from = domain.lower;
    axis.to = domain.upper;
    if (!domain.choices.empty()) {
        std::set<double> values;
        for (const std::vector<double>& choice : domain.choices) values.insert(choice[component.component]);
        axis.values.assign(values.begin(), values.end());
    } else if (component.scalar == Scalar::boolean) {
        axis.values = {0, 1};
    } else if (component.scalar != Scalar::float32) {
        axis.values = whole_numbers(domain.lower, domain.upper);
    }
    if (!axis.values.empty()) {
        axis.from = axis.values.front();
        axis.to = axis.values.back();
    }
    return axis;
}

double parse_end(const std::string& text, const std::string& part) {
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw Error("--axes {}: \"{}\" is no number; NAME or NAME=FROM:TO is needed, as p.x=0:0.5", part,
                    text);
    return value;
}

Axis parse_axis(const Case& c, const std::string& part) {
    const std::vector<Component> components = components_of(c);
    const std::string name = part.substr(0, part.find('='));
    std::vector<std::string> names;
    for (std::size_t word = 0; word < components.size(); ++word) {
        const Component& component = components[word];
        names.push_back(component.name);
        if (component.name != name) continue;
        Axis axis = axis_along(c, word, component);
        if (name.size() == part.size()) return axis;
        const std::string range = part.substr(name.size() + 1);
        const std::size_t colon = range.find(':');
        axis.from = parse_end(range.substr(0, colon), part);
        axis.to = parse_end(colon == range.npos ? "" : range.substr(colon + 1), part);
        if (!(axis.from < axis.to)) throw Error("--axes {}: the range is empty", part);
        if (component.scalar != Scalar::float32) {
            axis.values = whole_numbers(axis.from, axis.to);
            if (axis.values.empty()) throw Error("--axes {}: no whole number lies in the range", part);
        } else {
            axis.values.clear();
        }
        return axis;
    }
    throw Error("--axes {}: {} has no such input; it has {}", part, c.name, fmt::join(names, ", "));
}

double value_at(const Axis& axis, int pixel, int pixels) {
    if (!axis.values.empty())
        return axis
            .values[static_cast<std::size_t>(pixel) * axis.values.size() / static_cast<std::size_t>(pixels)];
    return axis.from + (axis.to - axis.from) * ((pixel + 0.5) / pixels);
}

} // namespace

std::array<Axis, 2> telling_axes(const Case& c, const std::vector<Whereabouts>& where) {
    const std::vector<Component> components = components_of(c);
    if (components.size() < 2)
        throw Error("{} has fewer than two inputs: no picture can be drawn over two", c.name);
    const auto rank = [&](std::size_t word) { // the less, the more telling
        if (!is_continuous(c, components[word])) return std::numeric_limits<std::size_t>::max();
        const auto found = std::ranges::find(where, components[word].name, &Whereabouts::name);
        return found == where.end() ? std::numeric_limits<std::size_t>::max() - 1 : found->inside;
    };
    std::vector<std::size_t> words(components.size());
    std::iota(words.begin(), words.end(), std::size_t{0});
    std::ranges::stable_sort(words, {}, rank);
    words.resize(2);
    std::ranges::sort(words);
    return {axis_along(c, words[0], components[words[0]]), axis_along(c, words[1], components[words[1]])};
}

std::array<Axis, 2> parse_axes(const Case& c, const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma == text.npos || text.find(',', comma + 1) != text.npos)
        throw Error("--axes {}: two inputs with a comma between them are needed, as p.x,p.y", text);
    std::array<Axis, 2> axes{parse_axis(c, text.substr(0, comma)), parse_axis(c, text.substr(comma + 1))};
    if (axes[0].word == axes[1].word) throw Error("--axes {}: two different inputs are needed", text);
    return axes;
}

Records picture_records(const Case& c, const std::array<Axis, 2>& axes, PictureSize size,
                        const CsvInput& rest) {
    Records records(c);
    records.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    std::vector<std::uint32_t> words = rest.words;
    for (int y = 0; y < size.height; ++y) {
        words[axes[1].word] = narrow(c.reference.words[axes[1].word], value_at(axes[1], y, size.height));
        for (int x = 0; x < size.width; ++x) {
            words[axes[0].word] = narrow(c.reference.words[axes[0].word], value_at(axes[0], x, size.width));
            records.add(words, c.reference.takes_mask ? &rest.mask : nullptr);
        }
    }
    return records;
}

Picture picture_of(const Case& c, const Records& records, PictureSize size, std::span<const std::uint32_t> a,
                   std::span<const std::uint32_t> b) {
    const Type type = c.reference.result;
    const auto components = static_cast<std::size_t>(type.components);
    const auto result = [&](std::span<const std::uint32_t> words, std::size_t i) {
        return words.subspan(i * components, components);
    };
    Picture picture;
    picture.image = Image(size.width, size.height, same_colour);
    std::vector<ResultDifference> differences;
    for (std::size_t i = 0; i < records.size(); ++i) {
        differences.push_back(difference_of(type, result(a, i), result(b, i)));
        if (!differences.back().finiteness)
            picture.scale = std::max(picture.scale, differences.back().absolute);
    }
    for (std::size_t i = 0; i < records.size(); ++i) {
        const ResultDifference& one = differences[i];
        Rgb& pixel = picture.image.pixels[i];
        if (one.differs) ++picture.differ;
        if (one.finiteness) {
            ++picture.finiteness;
            pixel = not_finite_colour;
        } else if (one.differs) {
            const double part = picture.scale > 0 ? std::max(palest, one.absolute / picture.scale) : palest;
            pixel = mixed(same_colour, one.change < 0 ? smaller_colour : larger_colour, part);
        } else if (std::isnan(widen(type.scalar, result(a, i)[0]))) {
            ++picture.both_nan;
            pixel = both_nan_colour;
        } else if (!in_domain(c, arguments(c, records.input(i), records.mask(i)))) {
            pixel = outside_colour;
        }
        if (!in_domain(c, arguments(c, records.input(i), records.mask(i)))) ++picture.outside;
    }
    return picture;
}

} // namespace gnomon::versus
