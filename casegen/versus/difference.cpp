#include "casegen/versus/difference.h"

#include "casegen/compare.h"
#include "casegen/csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gnomon::versus {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t few = 16; // values of a parameter that are told one by one

/// A value, or the values of a parameter with choices, as people read and sort them.
using Key = std::vector<double>;

std::string text_of(const Key& key) {
    return key.size() == 1 ? fmt::format("{:g}", key.front()) : fmt::format("({:g})", fmt::join(key, ", "));
}

/// Samples by value; empty if there are more than a few.
std::vector<ValueShare> shares(const std::vector<Key>& keys, const std::vector<std::size_t>& samples,
                               std::span<const std::uint8_t> differs) {
    std::map<Key, ValueShare> by_value;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        ValueShare& share = by_value[keys[i]];
        ++share.samples;
        if (differs[samples[i]] != 0) ++share.differ;
        if (by_value.size() > few) return {};
    }
    std::vector<ValueShare> all;
    for (auto& [key, share] : by_value) {
        share.value = text_of(key);
        all.push_back(std::move(share));
    }
    return all;
}

Whereabouts along(const std::string& name, const std::vector<double>& values,
                  const std::vector<std::size_t>& samples, std::span<const std::uint8_t> differs) {
    Whereabouts where;
    where.name = name;
    where.from = where.sampled_from = infinity;
    where.to = where.sampled_to = -infinity;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        where.sampled_from = std::min(where.sampled_from, values[i]);
        where.sampled_to = std::max(where.sampled_to, values[i]);
        if (differs[samples[i]] == 0) continue;
        where.from = std::min(where.from, values[i]);
        where.to = std::max(where.to, values[i]);
    }
    where.inside = static_cast<std::size_t>(
        std::ranges::count_if(values, [&](double v) { return where.from <= v && v <= where.to; }));
    return where;
}

/// `samples`: those in the domain.
std::vector<Whereabouts> whereabouts(const Case& c, const Records& records,
                                     const std::vector<std::size_t>& samples,
                                     std::span<const std::uint8_t> differs) {
    std::vector<Whereabouts> all;
    std::size_t word = 0;
    const std::vector<Component> components = components_of(c);
    for (std::size_t p = 0; p < c.parameters.size(); ++p) {
        const auto count = static_cast<std::size_t>(c.reference.parameters[p].components);
        const Scalar scalar = c.reference.parameters[p].scalar;
        const auto value = [&](std::size_t i, std::size_t k) {
            return widen(scalar, records.input(samples[i])[word + k]);
        };
        std::vector<ValueShare> chosen;
        if (!c.parameters[p].domain.choices.empty()) {
            std::vector<Key> keys(samples.size());
            for (std::size_t i = 0; i < samples.size(); ++i)
                for (std::size_t k = 0; k < count; ++k) keys[i].push_back(value(i, k));
            chosen = shares(keys, samples, differs);
        }
        if (!chosen.empty()) {
            Whereabouts where;
            where.name = c.parameters[p].name;
            where.values = std::move(chosen);
            all.push_back(std::move(where));
        } else {
            for (std::size_t k = 0; k < count; ++k) {
                std::vector<double> values;
                for (std::size_t i = 0; i < samples.size(); ++i) values.push_back(value(i, k));
                Whereabouts where = along(components[word + k].name, values, samples, differs);
                if (scalar != Scalar::float32) {
                    std::vector<Key> keys;
                    for (const double v : values) keys.push_back({v});
                    where.values = shares(keys, samples, differs);
                }
                all.push_back(std::move(where));
            }
        }
        word += count;
    }
    return all;
}

} // namespace

std::vector<Component> components_of(const Case& c) {
    std::vector<Component> all;
    for (std::size_t p = 0; p < c.parameters.size(); ++p) {
        const Type type = c.reference.parameters[p];
        for (std::size_t k = 0; k < static_cast<std::size_t>(type.components); ++k) {
            const std::string& name = c.parameters[p].name;
            all.push_back(
                {type.components == 1 ? name : fmt::format("{}.{}", name, "xyzw"[k]), p, k, type.scalar});
        }
    }
    return all;
}

ResultDifference difference_of(Type type, std::span<const std::uint32_t> a,
                               std::span<const std::uint32_t> b) {
    ResultDifference found;
    for (std::size_t k = 0; k < static_cast<std::size_t>(type.components); ++k) {
        if (a[k] == b[k]) continue;
        const double from = widen(type.scalar, a[k]), to = widen(type.scalar, b[k]);
        if (std::isnan(from) && std::isnan(to)) {
            found.other_nan = true;
            continue;
        }
        found.differs = true;
        const bool finite = std::isfinite(from) && std::isfinite(to);
        const double absolute = finite ? std::abs(to - from) : infinity;
        if (!finite) found.finiteness = true;
        if (absolute >= found.absolute) {
            found.absolute = absolute;
            found.change = to - from;
        }
        if (type.scalar == Scalar::float32)
            found.ulps = std::max(found.ulps, ulps_between(static_cast<float>(from), static_cast<float>(to)));
    }
    if (found.differs) found.other_nan = false;
    return found;
}

Difference difference(const Case& c, const Records& records, std::span<const std::uint8_t> defined,
                      std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
    const Type type = c.reference.result;
    const auto components = static_cast<std::size_t>(type.components);
    Difference all;
    all.samples = records.size();
    std::vector<std::uint8_t> differs(records.size(), 0);
    std::vector<std::size_t> in_domain;
    bool worst_defined = false;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (defined[i] != 0) in_domain.push_back(i);
        const ResultDifference one =
            difference_of(type, a.subspan(i * components, components), b.subspan(i * components, components));
        if (one.other_nan) ++all.other_nan;
        if (!one.differs) continue;
        differs[i] = 1;
        ++all.differ;
        if (defined[i] != 0) ++all.differ_defined;
        if (one.finiteness) ++all.finiteness;
        if (one.absolute == 0) ++all.zeros;
        all.most_ulps = std::max(all.most_ulps, one.ulps);
        const bool first_defined = defined[i] != 0 && !worst_defined;
        const bool as_good = (defined[i] != 0) == worst_defined;
        const bool larger =
            one.absolute > all.absolute || (one.absolute == all.absolute && one.ulps > all.ulps);
        if (all.differ == 1 || first_defined || (as_good && larger)) {
            all.worst = i;
            all.absolute = one.absolute;
            all.ulps = one.ulps;
            worst_defined = defined[i] != 0;
        }
    }
    all.defined = in_domain.size();
    if (all.differ_defined > 0) all.where = whereabouts(c, records, in_domain, differs);
    return all;
}

} // namespace gnomon::versus
