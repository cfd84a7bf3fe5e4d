// Which of two programs is faster, from times that were taken in turn on a machine that drifts and hiccups:
// an interval that the ratio lies in, and a verdict that is only given where the interval allows no other.
//
// In every round A, B and A again (A', the same program made a second time) run once, in an order drawn anew,
// so that whatever a round suffers from, each of them is as likely to suffer. The ratio of a round is B / A,
// that of its calibration A' / A. Nothing is assumed of the noise but that rounds are independent: the median
// of the ratios lies in an interval of order statistics with at least the stated probability, whatever the
// distribution, and one slow round in ten moves it by next to nothing. Means are never taken.
//
// A, B and A' may each contain the same constant (what reading their inputs costs): `floor`. A ratio of times
// with it is nearer to 1 than the ratio without; it is corrected by (r - f) / (1 - f), f = floor / median of
// A, which moves both ends of an interval alike. A wrong floor makes an effect larger or smaller, never turns
// it around. Where the floor is more than four fifths of A or of B there is next to nothing left of that
// to be compared: then it stays in, and the ratio and its margin are those of the whole.
//
// The margin within which two programs count as equally fast is the largest of
//   - the least effect that anybody cares about (3 %),
//   - the end of the calibration's interval that is farther from 1: two copies of one program were told apart
//     by as much, for whatever reason, so it is no evidence that B is another.
// The verdict is
//   same       the whole interval lies within the margin, and the margin is no wider than `most_margin`
//   faster     the whole interval lies below it: B takes less time
//   slower     the whole interval lies above it
//   uncertain  anything else
// If B's true ratio lies beyond the margin by however little, `same` is wrong, and if it does not, `faster`
// and `slower` are, each with a probability of at most 1 - confidence.
//
// To look at the rounds so far and go on if they do not decide is to have several chances to be wrong. Look
// number k (1, 2, …) therefore takes intervals of confidence 1 - (1 - confidence) / 2^k: all looks together,
// however many, are wrong with a probability of at most 1 - confidence. A number of rounds that is fixed
// beforehand is looked at once, at the full confidence.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

struct Interval {
    double lower = 0, upper = 0;
    bool contains(double value) const { return lower <= value && value <= upper; }
};

/// Where the median of what `values` were drawn from lies, with at least this confidence: the values of
/// ranks k and n + 1 - k, where k is the largest with P(Binomial(n, 1/2) < k) <= (1 - confidence) / 2. All
/// numbers (from -infinity to infinity) if there are too few values, 6 for 95 %. NaN is not a value.
Interval median_interval(std::vector<double> values, double confidence);

/// Nanoseconds, or any other unit: one of each per round. Positive and finite.
struct PairedTimes {
    std::vector<double> a, b, again; ///< of equal length; `again` are A's once more
    double floor = 0;                ///< a part of all three that is not to be compared
};

enum class Pace { same, faster, slower, uncertain };
const char* to_string(Pace pace); ///< "SAME", …

struct PaceOptions {
    double least_effect = 0.03; ///< a smaller one is none
    double most_margin = 0.10;  ///< where the machine cannot tell less apart, nothing is the same
    double confidence = 0.95;
    unsigned look = 0; ///< which look at rounds that go on; 0: the only one
};

struct PaceVerdict {
    Pace pace = Pace::uncertain;
    double ratio = 1;        ///< B / A: the median
    bool with_floor = false; ///< the floor is still in all ratios
    Interval interval;       ///< where the ratio lies
    double again = 1;        ///< A' / A: the median
    Interval calibration;    ///< where that lies
    double margin = 0;       ///< of "the same": ratios from 1 / (1 + margin) to 1 + margin
    double confidence = 0;   ///< of either interval, as corrected for this look
    std::size_t rounds = 0;
    std::string reason; ///< of an uncertain one: "the interval reaches across the margin"
};

/// Throws Error if the times are not as said above, or none at all.
PaceVerdict judge_times(const PairedTimes& times, const PaceOptions& options = {});

/// The rule alone, for ratios that come from elsewhere.
Pace pace_of(const Interval& ratio, double margin, double most_margin = PaceOptions().most_margin);

/// Whether more rounds would only confirm: faster or slower, or the same within the least effect.
bool settled(const PaceVerdict& verdict, const PaceOptions& options);

/// How many rounds there are at look 1, 2, …: 16, 32, 64 …
constexpr std::size_t rounds_at(unsigned look) { return std::size_t{8} << look; }

} // namespace gnomon::measure
