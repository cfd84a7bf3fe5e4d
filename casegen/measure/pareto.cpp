#include "casegen/measure/pareto.h"

#include <cmath>
#include <limits>
#include <tuple>

namespace gnomon::measure {
namespace {

double error_of(const Point& point) {
    return std::isnan(point.error) ? std::numeric_limits<double>::infinity() : point.error;
}

bool dominates(const Point& a, const Point& b, double noise) {
    if (std::isinf(error_of(b)) && !std::isinf(error_of(a))) return true;
    const bool faster = a.time * (1 + noise) < b.time;
    return (faster && error_of(a) <= same_error * error_of(b)) ||
           (a.time <= b.time && same_error * error_of(a) < error_of(b));
}

} // namespace

std::vector<std::optional<std::size_t>> dominated_by(std::span<const Point> points, double noise) {
    std::vector<std::optional<std::size_t>> by(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (i == j || !dominates(points[j], points[i], noise)) continue;
            const auto rank = [&](std::size_t n) {
                return std::tuple(error_of(points[n]), points[n].time, n);
            };
            if (!by[i] || rank(j) < rank(*by[i])) by[i] = j;
        }
    return by;
}

} // namespace gnomon::measure
