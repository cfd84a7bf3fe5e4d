// Which variants nobody needs: another one is no slower and no less accurate.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gnomon::measure {

struct Point {
    double time = 0, error = 0; ///< an infinite error is the largest there is; NaN is taken for one
};

/// Errors that differ by less than this factor are called equal: quantiles of samples differ by as much.
constexpr double same_error = 1.2;

/// Per point, the point that dominates it: either faster by more than the noise with no larger an error, or
/// no slower at all with a smaller one: noise works against the claim. What has no finite error is dominated
/// by whatever has one, for nobody needs a fast wrong number. Of several the most accurate, of those the
/// fastest, then the first. `noise` is a fraction of the time: 0.05. Equals do not dominate each other, and
/// nothing is dominated in a circle.
std::vector<std::optional<std::size_t>> dominated_by(std::span<const Point> points, double noise);

} // namespace gnomon::measure
