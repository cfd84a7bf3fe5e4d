// Does a kernel's check notice a change of its text? What check asks, in an order and with answers kept that
// make it quick: a few samples first, and only results that differ from the unchanged kernel's are judged.
#pragma once

#include "casegen/csv.h"
#include "casegen/kernel_case.h"
#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::mutate {

struct ExaminerOptions {
    glsl::Sources sources;             ///< frozen: workers that begin later must see the same kernels
    std::filesystem::path pins, worst; ///< folders; may be empty
    std::map<std::string, std::vector<CsvInput>> regressions;
    std::optional<std::size_t> samples; ///< as CheckOptions::samples, but at most most_samples
    std::optional<std::uint64_t> seed;  ///< as CheckOptions::seed
    gpu::DeviceOptions device;
};
constexpr std::size_t most_samples = std::size_t{1} << 18;

struct Examined {
    enum class Outcome {
        killed,    ///< the check fails
        survived,  ///< it passes
        same_code, ///< the change compiles to what the kernel compiles to, as it is or once it is optimised
        stillborn, ///< it does not compile
        broken,    ///< the unchanged kernel already fails
    };
    Outcome outcome = Outcome::survived;
    /// In words: the call that fails; how far a survivor's results are from the unchanged kernel's; glslang's
    /// message.
    std::string how;
};

/// A device, and the kernel that it was last asked about.
class Examiner {
public:
    /// Throws Error (no device).
    explicit Examiner(ExaminerOptions options);
    ~Examiner();

    /// How the unchanged kernel fails its check, in words; empty if it passes. Throws KernelTimeout, after
    /// which the examiner is of no more use.
    std::string complaint(const Case& c);

    /// `changed`: the sources with the change. Throws KernelTimeout, after which it is of no more use.
    Examined examine(const Case& c, const glsl::Sources& changed);

private:
    struct Subject;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon::mutate
