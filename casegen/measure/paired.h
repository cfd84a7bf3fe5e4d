// Two kernels timed against each other: A, B and A made a second time, round after round, until verdict.h's
// rule decides or the time is spent.
#pragma once

#include "casegen/measure/verdict.h"
#include "casegen/standalone.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <optional>
#include <span>

namespace gnomon::measure {

/// A kernel and the text it is compiled from.
struct Contestant {
    const Case* kernel = nullptr;
    glsl::Sources sources;
};

struct PairingOptions {
    double seconds = 3;                ///< begins no further round after these; compiling is not counted
    std::optional<std::size_t> rounds; ///< exactly so many instead, looked at once
    std::uint64_t seed = 1;            ///< of which inputs are taken, and of the order in each round
    PaceOptions pace;
};

struct Pairing {
    PaceVerdict verdict;
    /// Nanoseconds per evaluation: medians less the floor, which is what reading a record takes.
    double a = 0, b = 0, floor = 0;
    unsigned looks = 0;
    double seconds = 0;
};

/// On `timed_records` of the `chosen` ones of `records`, which both kernels must be able to read: one
/// signature. Throws CompileError, KernelTimeout; Error if nothing is chosen.
Pairing time_pair(gpu::Device& device, const Contestant& a, const Contestant& b, const Records& records,
                  std::span<const std::size_t> chosen, const PairingOptions& options);

} // namespace gnomon::measure
