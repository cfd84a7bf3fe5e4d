// A kernel that stays: its samples drawn, its truths computed, the results of its last state at hand, so that
// an edit costs compiling, one run, and judging what came out differently.
#pragma once

#include "casegen/check.h"
#include "casegen/standalone.h"
#include "casegen/truths.h"
#include "casegen/verdict.h"
#include "casegen/watch/message.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gnomon::watch {

class Subject {
public:
    /// Draws what check would draw. Throws Error if a file of pins is malformed.
    Subject(const Case& c, const CheckOptions& options, std::shared_ptr<const EdgePool> pool,
            std::span<const CsvInput> regressions);
    Subject(const Subject&) = delete; // records name masks of the sampler
    Subject& operator=(const Subject&) = delete;

    /// The verdict on `text`, the same as check's, beside the state that `before` compiles to (none if it is
    /// empty). `folder` is what messages call the kernels' folder, `replay` what a replay command says
    /// besides. Does not throw for what is wrong with the kernel.
    Judgement judge(gpu::Device& device, const std::string& text, const std::string& before,
                    const std::string& folder, const std::string& replay);

    const Records& records() const { return records_; }
    std::size_t random_begin() const { return sampler_.fixed_count(); } ///< the first random sample

private:
    /// A state that ran to its end.
    struct Ran {
        std::string text;
        glsl::Spirv words;
        Judged judged;
    };
    Ran run(gpu::Device& device, glsl::Spirv words, const std::string& text, CheckReport& report);
    Moved compare(const Ran& before, const Ran& after) const;

    const Case& case_;
    Sampler sampler_;
    Records records_;
    std::vector<Truth> truths_; ///< none if the reference has no truth
    std::optional<Ran> ran_;
};

/// A hash of a kernel's result words: what two processes compare their results by. Any NaN is as good as
/// another: its sign depends on whether a compiler or the processor made it.
std::uint64_t hash_of(const Case& c, std::span<const std::uint32_t> results);

} // namespace gnomon::watch
