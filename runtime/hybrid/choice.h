// Which of several techniques with the same image to take: the one that is fastest here and now.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

struct Candidate {
    std::string name;
    std::vector<double> milliseconds{}; ///< whole frames, in the order they were timed in
    std::string refused{};              ///< why it cannot be taken here; empty if it can
};

/// What a calibration found.
struct Choice {
    std::vector<Candidate> candidates;
    std::size_t chosen = 0;
    double milliseconds = 0; ///< that the calibration took
    const std::string& name() const { return candidates[chosen].name; }
};

struct CalibrationRules {
    int rounds = 5;        ///< that count; one more is discarded
    double margin = 0.05;  ///< the first candidate is kept unless another is faster by more than this share
    double give_up = 1.25; ///< who is never within this factor of the fastest is timed no further
};

/// Half of the times are below: of a candidate's. Infinity if it has none or refused: NaN times too.
double typical_time(const Candidate& candidate);

/// The candidate with the least typical time, the first of several; but the first of all if its time is
/// within `margin` of that: it needs no maps, and its time varies least from frame to frame. Who was timed
/// less often than others has lost. Throws Error if every one refused.
std::size_t fastest(std::span<const Candidate> candidates, double margin);

/// Times whole frames of the candidates in turns: `frame(i)` takes one with candidate i and returns its
/// milliseconds. A first round is discarded: it compiles, allocates, and builds what rays need. A candidate
/// whose `frame` throws Error in it is refused with that message. `milliseconds` is the caller's to fill in.
Choice calibrate(const std::vector<std::string>& names, const std::function<double(std::size_t)>& frame,
                 const CalibrationRules& rules = {});

} // namespace gnomon
