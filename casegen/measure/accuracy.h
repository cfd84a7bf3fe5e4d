// How wrong a variant is on given inputs: over all of them, by class, by locus, by distance.
#pragma once

#include "casegen/measure/inputs.h"
#include "casegen/measure/quantiles.h"

#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

/// How far off one result is, both ways that it is told. Infinite where the result is not finite.
struct Deviation {
    double of_scale = 0; ///< |got - want| / Truth::scale; without a truth, in the tolerance's own unit
    double of_limit = 0; ///< |got - want| in unit_of_error: what rounding the inputs does; 0 without a truth
};

/// Per record of `inputs`. `results` are the words that the device wrote.
std::vector<Deviation> deviations(const Case& c, const Inputs& inputs,
                                  std::span<const std::uint32_t> results);

/// unit_of_error / scale, the largest over the components: the error that no float32 kernel can promise to
/// stay below.
double limit_of(const Truth& truth, int components);

/// What a fraction of the scale is called, or the tolerance's unit: "of ∫|f|", "ulps".
std::string unit_of(const Case& c);

struct Summary {
    Quantiles of_scale, of_limit;
};

/// At one distance from a locus.
struct Step {
    int step = 0; ///< see locus_distance
    Summary summary;
    double limit = 0; ///< the median of limit_of
};

struct LocusSummary {
    std::string name, group;
    Summary all;
    std::vector<Step> steps; ///< from far away to "on it"; none where no input lies in the domain
};

struct Accuracy {
    Summary all;
    std::vector<Summary> classes;   ///< as Inputs::classes
    std::vector<LocusSummary> loci; ///< as the generator's
};

Accuracy summarise(const Case& c, const Inputs& inputs, std::span<const Deviation> deviations);

} // namespace gnomon::measure
