// One unit of a fuzzing campaign: some batches of one kernel's inputs on the device, judged, and what fails
// shrunk. Its results depend on the kernel, the campaign's seed and the unit's round alone, so that units may
// run in any order, on any number of workers, and again.
#pragma once

#include "casegen/fuzz/draw.h"
#include "casegen/fuzz/regression.h"
#include "runtime/gpu/device.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gnomon::fuzz {

struct FuzzerOptions {
    glsl::Sources sources;             ///< frozen: workers that begin later must see the same kernels
    std::filesystem::path pins, worst; ///< folders; may be empty
    std::map<std::string, std::vector<Regression>> regressions;
    std::uint64_t seed = 0;
    gpu::DeviceOptions device;
};

struct Unit {
    const Case* kernel = nullptr;
    std::uint64_t round = 0;            ///< the first one begins with all of the kernel's fixed samples
    std::size_t evaluations = 0;        ///< in whole batches, the last may be cut; fixed samples come on top
    bool shrink = true;                 ///< else failures are told as they were met
    std::optional<std::size_t> batches; ///< only so many of its first
};

/// A failure, shrunk.
struct Found {
    Regression regression;
    /// A regression that is on file fails like this already: nothing new, and not shrunk.
    bool on_file = false;
};

struct UnitResult {
    std::size_t evaluations = 0;
    double worst_error = 0; ///< the largest among results that pass, in the tolerance's own unit
    Input worst;            ///< if that is not 0
    std::vector<Found> found;
};

/// Evaluations of a unit, unless a campaign is short: as many as a worker does in some tenths of a second.
std::size_t unit_size(const Case& c);

/// Which records of which batch: what a unit is narrowed down to when it takes a device down.
struct Part {
    std::size_t batch = 0, begin = 0, end = 0;
};

/// A device, with kernels compiled when they are first asked for.
class Fuzzer {
public:
    explicit Fuzzer(FuzzerOptions options);
    ~Fuzzer();

    /// Failures in words of `known` are not shrunk, nor told. `batch` is set to the number of the batch
    /// before each: whoever shares its memory knows which one a driver died in. Throws CompileError,
    /// KernelTimeout.
    UnitResult run(const Unit& unit, const std::set<std::string>& known, std::atomic<std::uint32_t>& batch);

    /// The batch's inputs: runs those before it, which decide what it draws.
    std::vector<Input> inputs(const Unit& unit, std::size_t batch);

    /// Runs a part alone, without judging it.
    void dispatch(const Unit& unit, const Part& part);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon::fuzz
