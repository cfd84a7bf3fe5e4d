// A kernel on a device, to be asked about any inputs.
#pragma once

#include "casegen/fuzz/failure.h"
#include "casegen/fuzz/quick_judge.h"
#include "casegen/fuzz/regression.h"
#include "casegen/fuzz/shrink.h"
#include "runtime/gpu/device.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::fuzz {

class Subject {
public:
    /// Throws CompileError.
    Subject(const Case& c, const glsl::Sources& sources, gpu::Device& device);

    const Case& kernel() const { return case_; }
    const QuickJudge& quick() const { return quick_; }

    /// Throws KernelTimeout.
    Outputs run(const Records& records);

    /// Which of the records fails on its own with what a dispatch of all of them complains of (`failure`);
    /// the number of them if none does: they only do so together.
    std::size_t isolate(const Records& records, const std::string& failure);

    /// In words, per input; empty where it passes.
    std::vector<std::string> failures(std::span<const Input> inputs);

    /// The regression that an input shrinks to; nothing if it does not fail alone, but among others only.
    /// `found`: how it was found.
    std::optional<Regression> shrunk(const Input& input, const std::string& failure,
                                     const std::string& found);

private:
    Outputs run(std::span<const Input> inputs);

    const Case& case_;
    gpu::Device& device_;
    gpu::Kernel kernel_;
    QuickJudge quick_;
};

/// What the whole dispatch complains of, as a failure; empty if it does not.
std::string failure_of(const Outputs& outputs);

} // namespace gnomon::fuzz
