#include "casegen/measure/quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::measure {

double quantile(std::span<const double> sorted, double fraction) {
    // 0.9 * 10 is 9.000000000000002 in some other order of operations: forgive what rounding adds.
    const double rank = std::ceil(fraction * static_cast<double>(sorted.size()) - 1e-9);
    return sorted[rank < 1 ? 0 : std::min(static_cast<std::size_t>(rank), sorted.size()) - 1];
}

double median_of(std::vector<double> values) {
    std::ranges::sort(values);
    return quantile(values, 0.5);
}

Quantiles quantiles(std::vector<double> values) {
    Quantiles result;
    result.count = values.size();
    if (values.empty()) return result;
    for (double& value : values)
        if (!std::isfinite(value)) {
            value = std::numeric_limits<double>::infinity();
            ++result.non_finite;
        }
    std::ranges::sort(values);
    result.median = quantile(values, 0.5);
    result.p90 = quantile(values, 0.9);
    result.p99 = quantile(values, 0.99);
    result.most = values.back();
    return result;
}

} // namespace gnomon::measure
