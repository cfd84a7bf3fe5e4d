// A piece of work on the device that never changes: times over its own, taken in the same rounds, survive a
// slower machine, a busy one, and a change of every kernel.
#pragma once

#include "runtime/gpu/device.h"

#include <cstdint>

namespace gnomon::measure {

class Yardstick {
public:
    explicit Yardstick(gpu::Device& device);

    /// Nanoseconds per evaluation: some 50 additions, multiplications, roots and comparisons that wait for
    /// each other.
    double run();

    /// Of its text: times over another yardstick's are not comparable.
    static std::uint64_t fingerprint();

private:
    gpu::Device& device_;
    gpu::Kernel kernel_;
    gpu::Buffer results_;
};

} // namespace gnomon::measure
