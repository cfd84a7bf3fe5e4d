#include "casegen/measure/verdict.h"

#include "casegen/measure/quantiles.h"
#include "runtime/error.h"

#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::measure {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_floor = 0.8; // of a time

std::vector<double> log_ratios(std::span<const double> over, std::span<const double> under) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < over.size(); ++i) ratios.push_back(std::log(over[i] / under[i]));
    return ratios;
}

void require_times(const char* name, std::span<const double> times, std::size_t rounds) {
    if (times.size() != rounds)
        throw Error("{} times of {} in {} rounds: there must be one a round", times.size(), name, rounds);
    for (std::size_t i = 0; i < rounds; ++i)
        if (!(times[i] > 0 && std::isfinite(times[i])))
            throw Error("{} took {:g} in round {}, which is no time", name, times[i], i);
}

Interval exponential(const Interval& logarithms) {
    return {std::exp(logarithms.lower), std::exp(logarithms.upper)};
}

std::string percent(double fraction) { return fmt::format("{:.3g} %", fraction * 100); }

std::string why_uncertain(const PaceVerdict& verdict, const PaceOptions& options) {
    if (!std::isfinite(verdict.interval.upper)) return fmt::format("{} rounds are too few", verdict.rounds);
    if (verdict.margin > options.most_margin)
        return fmt::format("A differs from itself by up to {}", percent(verdict.margin));
    return fmt::format("the interval reaches across the margin of {}", percent(verdict.margin));
}

} // namespace

Interval median_interval(std::vector<double> values, double confidence) {
    const std::size_t n = values.size();
    if (n == 0) return {-infinity, infinity};
    std::ranges::sort(values);
    const boost::math::binomial_distribution<double> heads(static_cast<double>(n), 0.5);
    const double tail = (1 - confidence) / 2;
    std::size_t k = 0; // P(fewer than k heads) is what either end may miss by
    while (k + 1 <= (n + 1) / 2 && boost::math::cdf(heads, static_cast<double>(k)) <= tail) ++k;
    return k == 0 ? Interval{-infinity, infinity} : Interval{values[k - 1], values[n - k]};
}

const char* to_string(Pace pace) {
    switch (pace) {
    case Pace::same:
        return "SAME";
    case Pace::faster:
        return "FASTER";
    case Pace::slower:
        return "SLOWER";
    case Pace::uncertain:
        break;
    }
    return "UNCERTAIN";
}

Pace pace_of(const Interval& ratio, double margin, double most_margin) {
    if (ratio.upper < 1 / (1 + margin)) return Pace::faster;
    if (ratio.lower > 1 + margin) return Pace::slower;
    const bool within = ratio.lower >= 1 / (1 + margin) && ratio.upper <= 1 + margin;
    return within && margin <= most_margin ? Pace::same : Pace::uncertain;
}

PaceVerdict judge_times(const PairedTimes& times, const PaceOptions& options) {
    PaceVerdict verdict;
    verdict.rounds = times.a.size();
    if (verdict.rounds == 0) throw Error("no times to judge");
    require_times("A", times.a, verdict.rounds);
    require_times("B", times.b, verdict.rounds);
    require_times("A again", times.again, verdict.rounds);
    if (!(times.floor >= 0 && std::isfinite(times.floor)))
        throw Error("a floor of {:g} is no time", times.floor);

    verdict.confidence = 1 - (1 - options.confidence) * std::exp2(-static_cast<double>(options.look));
    double part = times.floor / median_of(times.a);
    verdict.with_floor = std::max(part, times.floor / median_of(times.b)) > most_floor;
    if (verdict.with_floor) part = 0;
    const auto net = [&](double ratio) { return std::max(0.0, (ratio - part) / (1 - part)); };
    const auto judge = [&](const std::vector<double>& over, double& median, Interval& interval) {
        const std::vector<double> ratios = log_ratios(over, times.a);
        const Interval gross = exponential(median_interval(ratios, verdict.confidence));
        median = net(std::exp(median_of(ratios)));
        interval = {net(gross.lower), net(gross.upper)};
    };
    judge(times.b, verdict.ratio, verdict.interval);
    judge(times.again, verdict.again, verdict.calibration);
    const Interval& self = verdict.calibration;
    verdict.margin = std::max({options.least_effect, self.upper - 1, 1 / self.lower - 1});
    verdict.pace = pace_of(verdict.interval, verdict.margin, options.most_margin);
    if (verdict.pace == Pace::uncertain) verdict.reason = why_uncertain(verdict, options);
    return verdict;
}

bool settled(const PaceVerdict& verdict, const PaceOptions& options) {
    if (verdict.pace == Pace::same) return verdict.margin <= options.least_effect;
    return verdict.pace != Pace::uncertain;
}

} // namespace gnomon::measure
