// The search for the inputs on which a kernel is most wrong: random starts, then small changes to the bits
// of the worst ones found, again and again.
#pragma once

#include "casegen/sampling.h"
#include "runtime/gpu/device.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace gnomon::worst {

/// One input and how wrong the kernel is on it, in its tolerance's own unit, as check judges it.
struct Row {
    std::vector<std::uint32_t> words;
    const Mask* mask = nullptr; ///< null if the kernel takes none
    double error = 0;
    bool passes = true;
};

/// At most this many are kept.
constexpr std::size_t most_rows = 32;

/// Rows of different octaves: of any two, some float differs in sign or exponent, or some other word, or the
/// mask. Of rows that do not the worst stays, else all of them would be one input and its neighbours. Worst
/// first, in an order that does not depend on that in which they were added.
class Worst {
public:
    explicit Worst(const Case& c) : case_(c) {}
    /// Rows whose error is 0 are not taken.
    void add(Row row);
    const std::vector<Row>& rows() const { return rows_; }

private:
    const Case& case_;
    std::vector<Row> rows_;
};

struct SearchOptions {
    std::filesystem::path kernels;
    std::filesystem::path worst, pins; ///< this kernel's files; either may be missing
    std::optional<std::uint64_t> seed; ///< else the kernel's own
    double seconds = 60;               ///< begins no new round after these
    std::size_t evaluations = 0;       ///< if not 0: exactly so many after the fixed samples, however long
    unsigned jobs = 0;                 ///< threads that judge; 0: one per core
    gpu::DeviceOptions device;
    const std::atomic<bool>* stop = nullptr; ///< ends the search after the round in which it becomes true
};

struct Found {
    std::vector<Row> before; ///< what the file held, judged anew, worst first
    std::vector<Row> rows;   ///< worst first
    std::size_t evaluations = 0;
    std::uint64_t seed = 0;
    std::shared_ptr<const Sampler> sampler; ///< whose masks the rows name
};

/// The same for the same seed and number of evaluations on any number of jobs. Begins with all of the
/// kernel's fixed samples, so with its worst ones. Searches outside the domain only if the kernel is defended
/// there and must pass. `progress` is told of seconds and evaluations so far, and the largest error, after
/// each round. Throws Error: no folder, no device, a malformed file, a kernel that does not compile or run.
Found search(const Case& c, const SearchOptions& options,
             const std::function<void(double seconds, std::size_t evaluations, double error)>& progress = {});

} // namespace gnomon::worst
