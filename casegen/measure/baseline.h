// What a bench found, as a file to measure against later: errors and instruction counts, which are the same
// bits on every machine with the same driver and compilers, and times over a yardstick's of the same rounds,
// which survive another machine better than nanoseconds do.
#pragma once

#include "casegen/measure/bench.h"
#include "casegen/measure/frames/frames.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

struct TimeRecord {
    Ratio ratio;      ///< over the yardstick's
    double noise = 0; ///< as a fraction: rounds, and one program against itself
};

/// A kernel, in one mode of trigonometry.
struct KernelRecord {
    std::string name; ///< "integral/sinc/a0", or with its mode behind: "integral/sinc/a0, built-in"
    std::string unit; ///< of the errors
    std::size_t inputs = 0;
    Quantiles error;                     ///< median, p99, most, non_finite; of no more use than that
    std::optional<Quantiles> over_limit; ///< in units of what rounding the inputs does
    std::size_t instructions = 0;
    std::optional<TimeRecord> time;
    /// An error that is larger by no more than this is another one, and not called worse: one unit of what
    /// the tolerance counts in (1 ulp, 1 κu), or, where it counts in nothing, all of it. Of `over_limit` if
    /// there is one. Not in the file: what is measured now says.
    double step = 0;
};

struct TechniqueRecord {
    std::string name;
    std::size_t wrong_lit = 0, wrong_shadowed = 0;
    double rmse = 0;
    std::optional<TimeRecord> time;
};

struct SceneRecord {
    std::string scene;
    int width = 0, height = 0, shadow_map = 0;
    std::size_t facing = 0;
    std::string yardstick; ///< the technique that times are over
    std::vector<TechniqueRecord> techniques;
};

struct Baseline {
    std::string machine, driver, compiler;
    std::size_t samples = 0, repeats = 0;
    std::optional<std::uint64_t> seed;
    unsigned rounds = 0;
    std::uint64_t yardstick = 0; ///< Yardstick::fingerprint
    std::vector<KernelRecord> kernels;
    std::vector<SceneRecord> scenes;
};

Baseline baseline_of(const Bench& bench, std::span<const SceneResult> scenes);

/// A line per kernel and per technique, so that a difference of two files can be read. What is not finite is
/// null.
std::string to_json(const Baseline& baseline);

/// `name` stands for the text in messages. Throws Error, in one line: not JSON, another format, a member that
/// is missing or not what it must be.
Baseline parse_baseline(const std::string& text, const std::string& name);

/// Throws Error, too, if there is no such file.
Baseline read_baseline(const std::filesystem::path& path);

} // namespace gnomon::measure
