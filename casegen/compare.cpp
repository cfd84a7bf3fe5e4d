#include "casegen/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace gnomon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double error_of(const Tolerance& tolerance, double got, double want, Scalar scalar) {
    if (got == want) return 0;
    if (scalar != Scalar::float32) return std::abs(got - want);
    const double difference = std::abs(got - want);
    const double in_ulps = ulps_between(static_cast<float>(got), static_cast<float>(want));
    switch (tolerance.kind) {
    case Tolerance::Kind::exact:
        return in_ulps == 0 ? 0 : difference; // the reference rounded to float
    case Tolerance::Kind::ulps:
        return in_ulps;
    case Tolerance::Kind::absolute:
    case Tolerance::Kind::input_within:
    case Tolerance::Kind::conditioned:
        break;
    }
    return difference;
}

/// Does the reference give `got` for some input whose float components (words `moved`) are moved by -d, 0 or
/// +d?
bool gives_near(const Case& c, const Arguments& arguments, const Numbers& got,
                std::span<const std::size_t> moved, double distance) {
    std::size_t combinations = 1;
    for (std::size_t i = 0; i < moved.size(); ++i) combinations *= 3;
    for (std::size_t n = 1; n < combinations; ++n) {
        Arguments near = arguments;
        std::size_t rest = n;
        for (const std::size_t w : moved) {
            near.numbers[w] += distance * (rest % 3 == 1 ? -1 : rest % 3 == 2 ? 1 : 0);
            rest /= 3;
        }
        const Numbers want = c.reference.call(near);
        if (std::equal(want.begin(), want.begin() + c.reference.result.components, got.begin())) return true;
    }
    return false;
}

/// About how far the input must be moved for the reference to give `got`: one of a few fractions of
/// `farthest`; infinity if neither that nor half of it is enough. The largest comes first: a straight border
/// that crosses the box of inputs has corners of it on both sides, so that most wrong results need no look at
/// the smaller ones.
double input_distance(const Case& c, const Arguments& arguments, const Numbers& got, double farthest) {
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < c.reference.words.size(); ++i)
        if (c.reference.words[i] == Scalar::float32) moved.push_back(i);
    const auto gives = [&](double distance) { return gives_near(c, arguments, got, moved, distance); };
    if (!gives(farthest) && !gives(0.5 * farthest)) return infinity;
    for (const double fraction : {0.125, 0.25, 0.5})
        if (gives(fraction * farthest)) return fraction * farthest;
    return farthest;
}

bool lies_within(const Bounds& bounds, const Case& c, const Numbers& got) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.reference.result.components); ++k) {
        const double lower = bounds.lower[k], upper = bounds.upper[k];
        if (!(got[k] >= lower && got[k] <= upper)) return false;
        const bool is_one_zero = lower == 0 && upper == 0 && std::signbit(lower) == std::signbit(upper);
        if (is_one_zero && std::signbit(got[k]) != std::signbit(lower)) return false;
    }
    return true;
}

} // namespace

double ulps_between(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return infinity;
    if (a == b) return 0;
    if (std::isinf(a) || std::isinf(b)) return infinity;
    const auto ordered = [](float f) { // monotone over all finite floats, -0 and +0 alike
        const auto bits = std::bit_cast<std::int32_t>(f);
        return static_cast<std::int64_t>(bits >= 0 ? bits : std::numeric_limits<std::int32_t>::min() - bits);
    };
    return static_cast<double>(std::llabs(ordered(a) - ordered(b)));
}

double unit_of_error(const Truth& truth, std::size_t component) {
    constexpr double smallest_normal = 0x1p-126, rounding = 0x1p-24;
    // NaN, the mark of a truth that is none, must come through: no std::max.
    const double least = truth.scale * rounding;
    const double unit = truth.conditioning[component] < least ? least : truth.conditioning[component];
    return unit < smallest_normal ? smallest_normal : unit;
}

bool exact_at(const Case& c, const Arguments& arguments) {
    return c.exact_where && c.exact_where(std::span(arguments.numbers).first(c.reference.words.size()));
}

bool keeps_rule(const Case& c, const Arguments& arguments, const Numbers& got) {
    if (!c.outside) return true;
    const auto bounds = c.outside(std::span(arguments.numbers).first(c.reference.words.size()));
    return !bounds || lies_within(*bounds, c, got);
}

Agreement judge(const Case& c, const Arguments& arguments, std::span<const std::uint32_t> result,
                const Truth* known) {
    const Type type = c.reference.result;
    const auto components = static_cast<std::size_t>(type.components);
    const bool defined = in_domain(c, arguments);
    Numbers got{};
    for (std::size_t k = 0; k < components; ++k) {
        got[k] = widen(type.scalar, result[k]);
        if ((defined || c.defended) && !(got[k] >= c.result.lower && got[k] <= c.result.upper))
            return {false, infinity};
    }
    if (!defined) return keeps_rule(c, arguments, got) ? Agreement{true, 0} : Agreement{false, infinity};
    if (c.tolerance.kind == Tolerance::Kind::conditioned) {
        const Truth truth = known ? *known : c.reference.truth(arguments);
        double error = 0;
        for (std::size_t k = 0; k < components; ++k) {
            const double of_component = std::abs(got[k] - truth.value[k]) / unit_of_error(truth, k);
            if (std::isnan(of_component)) return {false, infinity};
            error = std::max(error, of_component);
        }
        const std::span numbers = std::span(arguments.numbers).first(c.reference.words.size());
        if (c.within && !lies_within(c.within(numbers, truth), c, got)) return {false, infinity};
        return {error <= c.tolerance.amount, error};
    }
    const Numbers want = known ? known->value : c.reference.call(arguments);
    double error = 0;
    for (std::size_t k = 0; k < components; ++k) {
        if (std::isnan(want[k])) return {false, infinity}; // a gap of the reference agrees with nothing
        error = std::max(error, error_of(c.tolerance, got[k], want[k], type.scalar));
    }
    if (error > 0 && exact_at(c, arguments)) {
        for (std::size_t k = 0; k < components; ++k)
            if (error_of(exact(), got[k], want[k], type.scalar) > 0) return {false, error};
    }
    if (c.tolerance.kind != Tolerance::Kind::input_within) return {error <= c.tolerance.amount, error};
    if (error == 0) return {true, 0};
    const double distance = input_distance(c, arguments, got, c.tolerance.amount);
    return {distance <= c.tolerance.amount, distance};
}

} // namespace gnomon
