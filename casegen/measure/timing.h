// How long one evaluation takes on the device: many calls a thread on different records, less what reading
// the records costs; all variants in turn, round after round, so that a machine that slows down slows all of
// them alike.
#pragma once

#include "casegen/measure/inputs.h"
#include "casegen/measure/loop.h"
#include "casegen/measure/variant.h"
#include "casegen/measure/verdict.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

/// One time over another of the same round.
struct Ratio {
    double median = 0;
    Interval interval; ///< of the median, at 95 %: everything if there are fewer than 6 rounds
};

/// NaN where a round has no time. `times` and `over` have one of each per round.
Ratio ratio_of(const std::vector<double>& times, const std::vector<double>& over);

/// Nanoseconds per evaluation over the rounds.
struct Timing {
    double median = 0, least = 0, most = 0;
    Ratio over_yardstick; ///< with the reading: see yardstick.h
};

/// Of one set of inputs.
struct Timings {
    std::string inputs; ///< "ordinary", "all classes"
    double floor = 0;   ///< reading a record, which is taken off below
    double yardstick = 0;
    std::vector<Timing> variants;
    /// The first variant measured a second time in every round, over the first time: the median of the
    /// ratios, and the median of their distances from 1.
    double again = 1, again_spread = 0;
    /// How far a round is from its variant's median: the median of all of them, as a fraction.
    double spread = 0;
    /// Times with their reading that differ by no more than this fraction do not differ.
    double noise() const;
    /// Times below this are lost in the noise of reading.
    double least_time() const { return noise() * floor; }
};

struct TimingOptions {
    std::filesystem::path kernels;
    unsigned rounds = 9;
    std::uint64_t seed = 0; ///< of which inputs are taken
};

/// The noise of a machine that shows less.
constexpr double least_noise = 0.03;

/// Of every variant on `timed_records` of the inputs that are ordinary, and, where there are others, on as
/// many of all of them. `done` is called after each round.
std::vector<Timings> time_variants(gpu::Device& device, const Group& group, const Inputs& inputs,
                                   const TimingOptions& options, const std::function<void()>& done = {});

/// "AMD EPYC 9B14, 2 threads; llvmpipe (LLVM 15.0.6, 256 bits)".
std::string machine(const gpu::Device& device);

} // namespace gnomon::measure
