// Accuracy and time of variants, group by group.
#pragma once

#include "casegen/measure/accuracy.h"
#include "casegen/measure/pareto.h"
#include "casegen/measure/timing.h"
#include "casegen/measure/variant.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

struct BenchOptions {
    std::filesystem::path kernels;
    std::size_t samples = 1024;        ///< ordinary inputs
    std::size_t repeats = 16;          ///< inputs per locus and distance
    std::optional<std::uint64_t> seed; ///< else each group's own, as in check
    unsigned rounds = 9;               ///< 0: no times
    unsigned jobs = 0;                 ///< threads for truths; 0: one per core
    gpu::DeviceOptions device;
};

/// Which of a variant's errors a picture or a "dominated" is about.
enum class Rank { median, p99, most };
constexpr std::array ranks{Rank::median, Rank::p99, Rank::most};
const char* to_string(Rank rank); ///< "median", "99 %", "max"
double error_at(const Quantiles& quantiles, Rank rank);

struct GroupResult {
    Group group;
    std::string unit;       ///< of the errors: see unit_of
    bool has_limit = false; ///< there are truths, and so errors in units of the limit
    std::uint64_t seed = 0;
    std::vector<std::string> classes;
    std::vector<std::size_t> class_counts; ///< inputs of each class
    std::size_t inputs = 0, left_out = 0;
    std::vector<Accuracy> accuracy; ///< per variant
    /// Per variant: inputs of its kernel's own domain on which its result is not what its check allows.
    std::vector<std::size_t> beyond_tolerance;
    /// Per variant: of the optimised shader that calls the kernel once. The cost without noise.
    std::vector<std::size_t> instructions;
    std::vector<Timings> timings; ///< none if no time was taken; the last is on inputs of all classes
    /// Per rank and variant, over all inputs, by the last of the timings; empty without.
    std::array<std::vector<std::optional<std::size_t>>, ranks.size()> dominated;
};

struct Bench {
    std::string machine;
    std::string driver;   ///< "llvmpipe Mesa 22.3.6"
    std::string compiler; ///< glslang and SPIRV-Tools
    BenchOptions options;
    std::vector<GroupResult> groups;
};

/// All but the times is the same for the same seed on any number of jobs. `done` is told of each group.
/// Throws Error: no folder, no device, a kernel that does not compile or does not write its results.
Bench bench(std::span<const Group> groups, const BenchOptions& options,
            const std::function<void(std::size_t)>& done = {});

} // namespace gnomon::measure
