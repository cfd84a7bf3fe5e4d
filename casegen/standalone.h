// A kernel alone on the device: a generated main() that calls it once per sample, and the buffers it reads
// and writes.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/readings.h"
#include "casegen/sampling.h"
#include "casegen/trigonometry.h"
#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace gnomon {

/// Where kernels come from: the folder, and what the catalogue generates.
glsl::Sources kernel_sources(const std::filesystem::path& kernels, const Readings& readings = {},
                             Trigonometry trigonometry = Trigonometry::portable);

/// GLSL for the word of a value: floatBitsToUint(value).
std::string to_word(Scalar scalar, const std::string& value);

/// The compute shader around `c`: includes its file, reads a record, writes the result's words.
std::string standalone_source(const Case& c);

/// To time it: every thread of `count` calls the kernel `evaluations` times, on a record `repeated_stride`
/// further each time (in a circle of a power of two of them), and writes the sum of the results' words, so
/// that no call can be left out or moved out of the loop. Or the same without the calls: the records' words
/// summed up, what reading them costs. Push constants: count, the last record's number, evaluations.
enum class Repeated { calls, reads };
std::string repeated_source(const Case& c, Repeated what);
constexpr std::uint32_t repeated_stride = 1031; ///< odd: every record has its turn

/// What stands for that text in messages, and with it in the cache's key.
inline constexpr const char* standalone_name = "<main>";

/// standalone_source with all that it includes: the whole text that `c` compiles from. Throws CompileError if
/// a file is missing.
std::string standalone_text(const Case& c, const glsl::Sources& sources);

/// That text, compiled; `folder` is what messages call the kernels' folder. Throws CompileError: on the
/// author's line, or, if what fails is the generated call, a message that shows the signature which the table
/// declares. `kept` false neither looks into the cache nor leaves anything there: for a text that nobody asks
/// for again.
glsl::Spirv compile_standalone_text(const Case& c, const std::string& text, const std::string& folder,
                                    bool kept = true);

/// Both.
glsl::Spirv compile_standalone(const Case& c, const glsl::Sources& sources, bool kept = true);

/// Inputs as the device reads them: per sample the parameters' words, then (if the kernel takes a mask) four
/// that say where its mask is, padded to whole uvec4.
class Records {
public:
    explicit Records(const Case& c);

    void reserve(std::size_t samples) {
        words_.reserve(samples * stride_);
        mask_of_.reserve(samples);
    }
    /// `mask` may be null if the kernel takes none. A mask is packed once however many samples name it.
    void add(std::span<const std::uint32_t> words, const Mask* mask);
    /// The same with words and mask from `fill(std::span<std::uint32_t>) -> const Mask*`, without a copy.
    template <typename Fill>
    void add_with(Fill&& fill) {
        add_block(1, [&](std::span<std::uint32_t> row) { return fill(row.first(word_count_)); });
    }
    /// `count` samples on one mask: `fill` as in add_with, of rows that begin stride() words apart.
    template <typename Fill>
    void add_block(std::size_t count, Fill&& fill) {
        const std::size_t begin = words_.size();
        words_.resize(begin + count * stride_);
        place_mask(count, fill(std::span(words_).subspan(begin)));
    }

    std::size_t size() const { return mask_of_.size(); }
    std::size_t stride() const { return stride_; } ///< words per record, a multiple of 4
    std::span<const std::uint32_t> words() const { return words_; }
    std::span<const std::uint32_t> masks() const { return mask_words_; }
    std::span<const std::uint32_t> input(std::size_t index) const { ///< the parameters' words of one record
        return std::span(words_).subspan(index * stride_, word_count_);
    }
    const Mask* mask(std::size_t index) const { return mask_of_[index]; }

private:
    void place_mask(std::size_t count, const Mask* mask); ///< of the last `count` records

    bool takes_mask_;
    std::size_t word_count_, stride_;
    std::vector<std::uint32_t> words_, mask_words_;
    std::vector<const Mask*> mask_of_;                      ///< per record; null if the kernel takes none
    std::unordered_map<const Mask*, std::uint32_t> packed_; ///< the first word of each mask
};

/// Samples `begin` to `end` - 1. The sampler holds their masks.
Records draw_records(const Case& c, const Sampler& sampler, std::size_t begin, std::size_t end);

struct Outputs {
    /// What is wrong with the run itself, whatever the values: one sentence, or nothing.
    std::string complaint() const;

    std::vector<std::uint32_t> words;    ///< components(result) per record
    std::vector<std::uint8_t> unwritten; ///< 1 per record whose result the kernel did not write
    bool stray_write = false;            ///< something outside the results was overwritten
    bool unstable = false;               ///< two runs on the same inputs differ
    double nanoseconds = 0;              ///< of the second run: the first one compiles
};

/// Runs the kernel over the first eighth of the records (the hostile ones among them), then over all, each
/// time on poisoned memory with guards on either side. Throws KernelTimeout.
Outputs run_standalone(gpu::Device& device, gpu::Kernel& kernel, const Case& c, const Records& records);

/// All in one: compiles, uploads, runs, reads. For tests and `eval`.
Outputs evaluate(gpu::Device& device, const glsl::Sources& sources, const Case& c, const Records& records);

} // namespace gnomon
