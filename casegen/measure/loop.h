// A kernel in a loop on the device, to be timed: many calls a thread on different records (see
// repeated_source), so that a dispatch is long beside its start.
#pragma once

#include "casegen/measure/inputs.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gnomon::measure {

constexpr std::uint32_t evaluations_per_thread = 64;
constexpr std::uint32_t timed_records = 4096; ///< a power of two

struct Loop {
    gpu::Kernel kernel;
    bool reads_masks = false;
    std::uint32_t threads = 0;
};

/// What loops over kernels with one signature read and write.
struct LoopBuffers {
    gpu::Buffer records, masks, results;
};

/// `timed_records` of the chosen inputs, drawn anew each: a few of many, or many times a few.
LoopBuffers upload_for_loops(gpu::Device& device, const Case& c, const Records& records,
                             std::span<const std::size_t> chosen, std::uint64_t seed);

/// Compiles; runs once for the driver's compiler, and once more to see how many threads make a dispatch of
/// `nanoseconds`: long beside its start, short beside a hiccup.
Loop make_loop(gpu::Device& device, const Case& c, const glsl::Sources& sources, Repeated what,
               const LoopBuffers& buffers, double nanoseconds = 8e6);

/// The same of a loop that is compiled already.
Loop make_loop(gpu::Device& device, const Case& c, const glsl::Spirv& words, Repeated what,
               const LoopBuffers& buffers, double nanoseconds = 8e6);

/// Nanoseconds per evaluation. Throws KernelTimeout.
double run_once(gpu::Device& device, Loop& loop, const LoopBuffers& buffers);

} // namespace gnomon::measure
