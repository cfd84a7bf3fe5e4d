#include "casegen/measure/accuracy.h"

#include "casegen/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::measure {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Below this a rounding of the scale is no normal float any more, and a device may flush it: see
/// unit_of_error.
double scale_of(const Truth& truth) { return truth.scale < 0x1p-102 ? 0x1p-102 : truth.scale; }

/// NaN is no error that could be compared: it is infinite.
double at_worst(double error) { return std::isfinite(error) ? error : infinity; }

template <typename Chosen>
Summary summary_of(std::span<const Deviation> deviations, Chosen&& chosen) {
    std::vector<double> of_scale, of_limit;
    for (std::size_t i = 0; i < deviations.size(); ++i)
        if (chosen(i)) {
            of_scale.push_back(deviations[i].of_scale);
            of_limit.push_back(deviations[i].of_limit);
        }
    return {quantiles(std::move(of_scale)), quantiles(std::move(of_limit))};
}

} // namespace

std::vector<Deviation> deviations(const Case& c, const Inputs& inputs,
                                  std::span<const std::uint32_t> results) {
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    std::vector<Deviation> all;
    all.reserve(inputs.records.size());
    for (std::size_t i = 0; i < inputs.records.size(); ++i) {
        const std::span got = results.subspan(i * components, components);
        Deviation error;
        if (inputs.truths.empty()) {
            const Arguments with = arguments(c, inputs.records.input(i), inputs.records.mask(i));
            error.of_scale = at_worst(judge(c, with, got).error);
        } else {
            const Truth& truth = inputs.truths[i];
            for (std::size_t k = 0; k < components; ++k) {
                const double difference = std::abs(widen(c.reference.result.scalar, got[k]) - truth.value[k]);
                error.of_scale = std::max(error.of_scale, at_worst(difference / scale_of(truth)));
                error.of_limit = std::max(error.of_limit, at_worst(difference / unit_of_error(truth, k)));
            }
        }
        all.push_back(error);
    }
    return all;
}

double limit_of(const Truth& truth, int components) {
    double limit = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(components); ++k)
        limit = std::max(limit, at_worst(unit_of_error(truth, k) / scale_of(truth)));
    return limit;
}

std::string unit_of(const Case& c) {
    if (c.reference.truth) return "of the scale";
    switch (c.tolerance.kind) {
    case Tolerance::Kind::ulps:
        return "ulps";
    case Tolerance::Kind::input_within:
        return "distance of the input";
    case Tolerance::Kind::exact:
    case Tolerance::Kind::absolute:
    case Tolerance::Kind::conditioned:
        break;
    }
    return "absolute";
}

Accuracy summarise(const Case& c, const Inputs& inputs, std::span<const Deviation> deviations) {
    Accuracy accuracy;
    accuracy.all = summary_of(deviations, [](std::size_t) { return true; });
    for (std::size_t n = 0; n < inputs.classes.size(); ++n)
        accuracy.classes.push_back(
            summary_of(deviations, [&](std::size_t i) { return inputs.class_of[i] == n; }));
    if (!c.generator) return accuracy;
    for (std::size_t n = 0; n < c.generator->loci.size(); ++n) {
        const auto of_locus = [&](std::size_t i) { return inputs.places[i] && inputs.places[i]->locus == n; };
        LocusSummary locus{
            c.generator->loci[n].name, c.generator->loci[n].group, summary_of(deviations, of_locus), {}};
        for (int nth = 1; nth <= locus_distances; ++nth) {
            const int step = nth % locus_distances; // 1 … 12, and 0, on it, last
            const auto of_step = [&](std::size_t i) { return of_locus(i) && inputs.places[i]->step == step; };
            Step at{step, summary_of(deviations, of_step), 0};
            if (at.summary.of_scale.count == 0) continue;
            std::vector<double> limits;
            for (std::size_t i = 0; i < inputs.truths.size(); ++i)
                if (of_step(i)) limits.push_back(limit_of(inputs.truths[i], c.reference.result.components));
            at.limit = quantiles(std::move(limits)).median;
            locus.steps.push_back(std::move(at));
        }
        accuracy.loci.push_back(std::move(locus));
    }
    return accuracy;
}

} // namespace gnomon::measure
