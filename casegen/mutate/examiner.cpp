#include "casegen/mutate/examiner.h"

#include "casegen/check.h"
#include "casegen/compare.h"
#include "casegen/sampling.h"
#include "casegen/standalone.h"
#include "casegen/truths.h"
#include "runtime/error.h"
#include "runtime/glsl/optimizer.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::mutate {
namespace {

/// Of so many samples one is among those that are run first.
constexpr std::size_t first_of = 16;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string failed_call(const Case& c, const Records& records, std::size_t i,
                        std::span<const std::uint32_t> got) {
    const Arguments with = arguments(c, records.input(i), records.mask(i));
    return fmt::format("{}: got {}, want {}", format_call(c, records.input(i), records.mask(i)),
                       format_result(c, got), format_want(c, with));
}

} // namespace

/// A kernel with its samples and what it answers unchanged.
struct Examiner::Subject {
    Subject(const Case& kernel_case, const ExaminerOptions& options,
            const std::shared_ptr<const EdgePool>& pool, gpu::Device& device)
        : c(kernel_case), all(c), few(c),
          components(static_cast<std::size_t>(c.reference.result.components)) {
        const auto file = [&](const std::filesystem::path& folder) {
            return folder.empty() ? folder : folder / (c.name + ".csv");
        };
        const auto found = options.regressions.find(c.name);
        sampler.emplace(c, options.seed.value_or(default_seed(c)), pool, file(options.pins),
                        file(options.worst),
                        found == options.regressions.end() ? std::span<const CsvInput>() : found->second);
        all = draw_records(c, *sampler, 0,
                           std::max(std::min(options.samples.value_or(default_samples(c)), most_samples),
                                    sampler->fixed_count()));
        for (std::size_t i = 0; i < all.size(); i += first_of) few.add(all.input(i), all.mask(i));
        try {
            words = compile_standalone(c, options.sources);
        } catch (const CompileError& error) {
            broken = first_line(error.what());
            return;
        }
        gpu::Kernel kernel = device.kernel(words, c.name);
        const Outputs outputs = run_standalone(device, kernel, c, all);
        unchanged = outputs.words;
        known = truths(c, all);
        broken = outputs.complaint();
        for (std::size_t i = 0; i < all.size() && broken.empty(); ++i)
            if (!passes(all, i, i, result(outputs, i))) broken = failed_call(c, all, i, result(outputs, i));
    }

    std::span<const std::uint32_t> result(const Outputs& outputs, std::size_t i) const {
        return {outputs.words.data() + i * components, components};
    }
    /// Record i of `records`, which is sample `sample`.
    bool passes(const Records& records, std::size_t i, std::size_t sample,
                std::span<const std::uint32_t> got) const {
        return judge(c, arguments(c, records.input(i), records.mask(i)), got,
                     known.empty() ? nullptr : &known[sample])
            .pass;
    }

    const Case& c;
    std::optional<Sampler> sampler;
    Records all, few; ///< few: every so many of all
    std::size_t components;
    glsl::Spirv words;
    std::optional<glsl::Spirv> optimized;
    std::vector<std::uint32_t> unchanged; ///< results
    std::vector<Truth> known;
    std::string broken; ///< how it fails, if it does
};

struct Examiner::Impl {
    explicit Impl(ExaminerOptions given)
        : options(std::move(given)), device(options.device),
          pool(std::make_shared<const EdgePool>(
              make_edge_pool(options.seed.value_or(default_seed("masks"))))) {}

    Subject& subject_of(const Case& c) {
        if (!subject || &subject->c != &c) subject = std::make_unique<Subject>(c, options, pool, device);
        return *subject;
    }

    ExaminerOptions options;
    gpu::Device device;
    std::shared_ptr<const EdgePool> pool;
    std::unique_ptr<Subject> subject;
};

Examiner::Examiner(ExaminerOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Examiner::~Examiner() = default;

std::string Examiner::complaint(const Case& c) { return impl_->subject_of(c).broken; }

Examined Examiner::examine(const Case& c, const glsl::Sources& changed) {
    using enum Examined::Outcome;
    Subject& subject = impl_->subject_of(c);
    if (!subject.broken.empty()) return {broken, subject.broken};
    glsl::Spirv words;
    try {
        words = compile_standalone(c, changed, false);
    } catch (const CompileError& error) {
        return {stillborn, first_line(error.what())};
    }
    if (words == subject.words) return {same_code, "the same SPIR-V"};
    gpu::Kernel kernel = impl_->device.kernel(words, c.name);
    std::size_t different = 0;
    for (const Records* records : {&subject.few, &subject.all}) {
        const std::size_t stride = records == &subject.few ? first_of : 1;
        const Outputs outputs = run_standalone(impl_->device, kernel, c, *records);
        if (const std::string complaint = outputs.complaint(); !complaint.empty()) return {killed, complaint};
        different = 0;
        for (std::size_t i = 0; i < records->size(); ++i) {
            const std::span<const std::uint32_t> got = subject.result(outputs, i);
            if (std::ranges::equal(got, std::span(subject.unchanged)
                                            .subspan(i * stride * subject.components, subject.components)))
                continue;
            ++different;
            if (!subject.passes(*records, i, i * stride, got))
                return {killed, failed_call(c, *records, i, got)};
        }
    }
    if (!subject.optimized) subject.optimized = glsl::optimized(subject.words);
    if (glsl::optimized(words) == *subject.optimized)
        return {same_code, "the same SPIR-V once it is optimised"};
    return {survived, different == 0 ? fmt::format("the same results on all {} samples", subject.all.size())
                                     : fmt::format("other results, within the tolerance, on {} of {} samples",
                                                   different, subject.all.size())};
}

} // namespace gnomon::mutate
