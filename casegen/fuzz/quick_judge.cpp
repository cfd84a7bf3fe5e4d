#include "casegen/fuzz/quick_judge.h"

#include "casegen/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gnomon::fuzz {
namespace {

unsigned bit(bool condition) { return condition ? 1u : 0u; }

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest errors of a batch, and which records they are.
class Largest {
public:
    void add(double error, std::size_t record) {
        if (error <= least_) return;
        errors_.emplace_back(error, record);
        if (errors_.size() < 4 * kept) return;
        cut();
        least_ = errors_.back().first;
    }
    void append_to(std::vector<std::size_t>& records) {
        if (errors_.size() > kept) cut();
        for (const auto& [error, record] : errors_) records.push_back(record);
    }

private:
    static constexpr std::size_t kept = 64;
    /// Of equal errors the first records stay, so that what stays depends on the batch alone.
    void cut() {
        std::ranges::sort(errors_, [](const auto& a, const auto& b) {
            return a.first != b.first ? a.first > b.first : a.second < b.second;
        });
        errors_.resize(kept);
    }
    std::vector<std::pair<double, std::size_t>> errors_;
    double least_ = 0;
};

/// A bit for each of the listed values if all are whole numbers from 0 to 63 and one to an input; else 0.
std::uint64_t few_of(Type type, const Domain& domain) {
    if (type.components != 1 || type.scalar == Scalar::float32) return 0;
    std::uint64_t few = 0;
    for (const std::vector<double>& choice : domain.choices) {
        if (!(choice[0] >= 0 && choice[0] <= 63)) return 0;
        few |= std::uint64_t{1} << static_cast<unsigned>(choice[0]);
    }
    return few;
}

} // namespace

QuickJudge::QuickJudge(const Case& c) : case_(c) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Type type = c.reference.parameters[i];
        const Domain& domain = c.parameters[i].domain;
        const bool listed = !domain.choices.empty();
        const auto components = static_cast<std::size_t>(type.components);
        if (const std::uint64_t few = listed ? few_of(type, domain) : 0; few != 0) {
            few_.push_back({first, type.scalar, few});
        } else {
            if (listed) choices_.push_back({first, components, &domain.choices});
            std::vector<Bounded>& words = type.scalar == Scalar::float32 ? floats_ : wholes_;
            for (std::size_t k = 0; k < components; ++k)
                words.push_back({first + k, type.scalar, listed ? -infinity : domain.lower,
                                 listed ? infinity : domain.upper});
        }
        first += components;
    }
}

QuickJudge::Read QuickJudge::read(std::span<const std::uint32_t> words, const Mask* mask) const {
    Read record;
    record.arguments.mask = mask;
    std::array<double, 16>& numbers = record.arguments.numbers;
    unsigned within = 1; // no way out halfway: a branch that nobody can predict costs more than the rest
    const auto take = [&](const Bounded& bounded, Scalar scalar) {
        const double number = widen(scalar, words[bounded.word]);
        numbers[bounded.word] = number;
        within &= bit(number >= bounded.lower) & bit(number <= bounded.upper);
    };
    for (const Bounded& bounded : floats_) take(bounded, Scalar::float32);
    for (const Bounded& bounded : wholes_) take(bounded, bounded.scalar);
    for (const Few& few : few_) {
        const std::uint32_t word = words[few.word];
        numbers[few.word] = widen(few.scalar, word);
        within &= bit(word < 64) & bit((few.allowed >> (word & 63) & 1) != 0);
    }
    const auto is_listed = [&](const Choices& choices) {
        const std::span of = std::span(numbers).subspan(choices.word, choices.components);
        return std::ranges::any_of(*choices.values,
                                   [&](const auto& values) { return std::ranges::equal(values, of); });
    };
    record.inside = within != 0 && std::ranges::all_of(choices_, is_listed) &&
                    (!case_.where || case_.where(record.arguments));
    return record;
}

std::vector<std::size_t> QuickJudge::to_look_at(const Records& records,
                                                std::span<const std::uint32_t> results) const {
    std::vector<std::size_t> found;
    if (case_.reference.truth) {
        found.resize(records.size());
        std::iota(found.begin(), found.end(), std::size_t{0});
        return found;
    }
    const Type type = case_.reference.result;
    const auto components = static_cast<std::size_t>(type.components);
    const Tolerance& tolerance = case_.tolerance;
    const bool by_difference = tolerance.kind == Tolerance::Kind::absolute;
    Largest largest;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto [with, defined] = read(records.input(i), records.mask(i));
        unsigned in_range = 1;
        Numbers got{};
        for (std::size_t k = 0; k < components; ++k) {
            got[k] = widen(type.scalar, results[i * components + k]);
            in_range &= bit(got[k] >= case_.result.lower) & bit(got[k] <= case_.result.upper);
        }
        if (in_range == 0) {
            if (defined || case_.defended) found.push_back(i);
            continue;
        }
        if (!defined && !case_.outside) continue;
        if (!defined) {
            if (!keeps_rule(case_, with, got)) found.push_back(i);
            continue;
        }
        const Numbers want = case_.reference.call(with);
        double difference = 0;
        bool nearest = true; // the float next to what is wanted
        for (std::size_t k = 0; k < components; ++k) {
            const double of_component = std::abs(got[k] - want[k]);
            nearest = nearest & (static_cast<double>(static_cast<float>(want[k])) == got[k]);
            difference = of_component <= difference ? difference : of_component; // NaN comes through
        }
        if (difference == 0) continue;
        if (by_difference && difference <= tolerance.amount && (nearest || !exact_at(case_, with)))
            largest.add(difference, i);
        else
            found.push_back(i);
    }
    largest.append_to(found);
    std::ranges::sort(found);
    return found;
}

} // namespace gnomon::fuzz
