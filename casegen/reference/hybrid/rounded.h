// What float32 arithmetic may make of a number, operation by operation: an interval that holds the exact
// result and whatever a device may round it to. Where a result is a float there is nothing to round, so that
// borders between two answers can be asked for exactly.
#pragma once

#include <algorithm>
#include <cmath>

namespace gnomon::reference::hybrid {

class Rounded {
public:
    Rounded(double number) : low_(number), high_(number) {} // NOLINT: formulas read 2 * x

    double low() const { return low_; }
    double high() const { return high_; }

    friend Rounded operator+(const Rounded& a, const Rounded& b) {
        const double low = a.low_ + b.low_, high = a.high_ + b.high_;
        // A double may round, too: what is left of either term shows it.
        const double of_b = low - a.low_, rest = (a.low_ - (low - of_b)) + (b.low_ - of_b);
        return rounded(low, high, rest == 0);
    }
    friend Rounded operator-(const Rounded& a, const Rounded& b) { return a + -b; }
    friend Rounded operator-(const Rounded& a) { return held(-a.high_, -a.low_); }
    friend Rounded operator*(const Rounded& a, const Rounded& b) {
        const auto [low, high] =
            std::minmax({a.low_ * b.low_, a.low_ * b.high_, a.high_ * b.low_, a.high_ * b.high_});
        return rounded(low, high, true); // two floats' product is a double
    }
    friend Rounded abs(const Rounded& a) {
        return a.low_ >= 0 ? a : a.high_ <= 0 ? -a : held(0, std::max(-a.low_, a.high_));
    }
    friend Rounded max(const Rounded& a, const Rounded& b) {
        return held(std::max(a.low_, b.low_), std::max(a.high_, b.high_));
    }

    /// Whether a > b for sure, whatever is rounded; and whether it surely is not.
    friend bool surely_greater(const Rounded& a, const Rounded& b) { return a.low_ > b.high_; }
    friend bool surely_not_greater(const Rounded& a, const Rounded& b) { return a.high_ <= b.low_; }

private:
    static Rounded held(double low, double high) {
        Rounded result(low);
        result.high_ = high;
        return result;
    }
    /// An operation's result: itself if it is a float, else within two roundings of it, which among denormal
    /// floats are absolute; and what is below the smallest normal float may be taken for 0.
    static Rounded rounded(double low, double high, bool exact) {
        constexpr double smallest_normal = 0x1p-126;
        if (exact && low == high && low == static_cast<double>(static_cast<float>(low)) &&
            (low == 0 || std::abs(low) >= smallest_normal))
            return low;
        low -= 0x1p-23 * std::abs(low) + 0x1p-149, high += 0x1p-23 * std::abs(high) + 0x1p-149;
        return held(low < smallest_normal ? std::min(low, 0.0) : low,
                    high > -smallest_normal ? std::max(high, 0.0) : high);
    }

    double low_, high_;
};

/// Twice the area of the triangle that two sides make.
inline Rounded cross(const Rounded& ax, const Rounded& ay, const Rounded& bx, const Rounded& by) {
    return ax * by - ay * bx;
}

} // namespace gnomon::reference::hybrid
