// Checking kernels: every sample on the device, judged against the reference.
#pragma once

#include "casegen/catalogue.h"
#include "casegen/sampling.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

class WorkerDevice;

struct CheckOptions {
    std::filesystem::path kernels; ///< the folder that holds <name>.glsl
    std::filesystem::path pins;    ///< the folder that holds <name>.csv; may be empty
    std::filesystem::path worst; ///< the same of the worst inputs ever found, which are run before all others
    std::filesystem::path regressions; ///< the folder of what fuzzing found; may be empty
    /// Per kernel (default: default_samples); worst ones, pins, hostile and stiff values are run even if they
    /// are more.
    std::optional<std::size_t> samples;
    std::optional<std::uint64_t> seed; ///< for every kernel; else each has its own, its name's hash
    gpu::DeviceOptions device;
    unsigned jobs = 0; ///< worker threads, each with its own device; 0: one per core
};

/// How many samples a kernel runs on if nobody says: as many as its reference answers in a blink.
inline std::size_t default_samples(const Case& c) { return c.reference.truth ? 8192 : 65536; }

/// What `check` counts up to, but for kernels whose fixed samples are more.
std::size_t samples_asked_for(std::span<const Case* const> cases, const CheckOptions& options);

enum class Verdict {
    pass,
    expected,       ///< wrong, as its table says that it must be
    passes_wrongly, ///< passes although its table says that it must fail
    wrong,          ///< a result outside the tolerance, outside its range, or NaN
    unwritten,      ///< a result that the kernel never wrote
    stray_write,    ///< memory beside the results was overwritten
    unstable,       ///< two runs over the same inputs differ
    compile_error,  ///< the message says where
    timeout,        ///< did not end within the device's time limit
};
std::string to_string(Verdict verdict);
/// Whether the verdict is the one that the kernel's table asks for.
inline bool is_good(Verdict verdict) { return verdict == Verdict::pass || verdict == Verdict::expected; }

/// One input and what became of it.
struct Finding {
    std::size_t index = 0; ///< the sample's number
    std::vector<std::uint32_t> input;
    std::optional<Mask> mask;
    std::vector<std::uint32_t> got;
    Numbers want{};
    bool in_domain = true; ///< else only the range was asked for
    double error = 0;
};

struct CheckReport {
    const Case* kernel = nullptr;
    Verdict verdict = Verdict::pass;
    std::uint64_t seed = 0;
    std::size_t samples = 0;
    std::size_t failures = 0;
    std::optional<Finding> worst; ///< the largest error, on a pass too; the first of equals
    double nanoseconds = 0;       ///< per evaluation
    std::string message;          ///< why it failed, when there is no finding to show
};

/// Throws Error if this is no folder: --kernels is wrong.
void require_kernels(const std::filesystem::path& kernels);

/// Reports in the order of `cases`, the same whatever the number of jobs (but for `nanoseconds`). `done` is
/// called from worker threads, one at a time, with the number of samples judged so far, of all kernels
/// together. A kernel that fails does not stop the others. Throws Error for what concerns all of them: no
/// such folder, no device, a malformed file of pins. `first`: a device of `options.device` that is starting
/// already, for one of the threads; may be null.
std::vector<CheckReport> check(std::span<const Case* const> cases, const CheckOptions& options,
                               const std::function<void(std::size_t)>& done = {},
                               WorkerDevice* first = nullptr);

/// "smsr_case_09(p = vec2(0x1.8p-1, 0x0p+0), along_x = 0x1p-1)"; a mask is appended as text.
std::string format_call(const Case& c, std::span<const std::uint32_t> input, const Mask* mask);
/// "0x1p+0", "vec2(…)": a result's words; and the reference's value in the same form.
std::string format_result(const Case& c, std::span<const std::uint32_t> words);
std::string format_result(const Case& c, const Numbers& numbers);
/// What is asked for at an input: the reference's value; outside the domain what the rule says, "anything
/// from 0 to 1".
std::string format_want(const Case& c, const Arguments& arguments);
/// The command that runs this very input again and shows result and reference. `options` are the program's
/// own that it needs for that, each behind a blank (" --kernels 'mine'").
std::string replay_command(const Case& c, const Finding& finding, const std::string& options = {});

/// What a person needs to know of a kernel that fails, line by line: message, call, got and want, replay
/// command with `options`, number of failures.
std::vector<std::string> explain_failure(const CheckReport& report, const std::string& options = {});

/// "0", "5.96e-08", "none finite".
std::string format_error(double error);

} // namespace gnomon
