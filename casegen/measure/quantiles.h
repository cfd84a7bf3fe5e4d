// Quantiles that forget nothing: what is not finite counts as larger than everything.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gnomon::measure {

struct Quantiles {
    double median = 0, p90 = 0, p99 = 0, most = 0; ///< infinity where so many values are not finite
    std::size_t count = 0, non_finite = 0;

    double non_finite_share() const {
        return count > 0 ? static_cast<double>(non_finite) / static_cast<double>(count) : 0;
    }
};

/// The least value that at least this fraction of the values does not exceed (nearest rank): always one of
/// them, so that infinity is never averaged with anything. `sorted` must be; NaN is not a value.
double quantile(std::span<const double> sorted, double fraction);

/// The lower of both in the middle of an even number of values. Of at least one.
double median_of(std::vector<double> values);

/// Of any values; NaN is taken for infinity. All 0 of none.
Quantiles quantiles(std::vector<double> values);

} // namespace gnomon::measure
