#include "casegen/watch/subject.h"

#include "runtime/error.h"
#include "runtime/glsl/names.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace gnomon::watch {
namespace {

/// How far apart two result words are: infinitely if only one of them is a number.
double difference(Scalar scalar, std::uint32_t a, std::uint32_t b) {
    const double x = widen(scalar, a), y = widen(scalar, b);
    if (x == y || (std::isnan(x) && std::isnan(y))) return 0;
    const double apart = std::abs(x - y);
    return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}

Judgement judgement_of(const CheckReport& report, const std::string& replay) {
    const Case& c = *report.kernel;
    Judgement judgement;
    judgement.verdict = to_string(report.verdict);
    judgement.good = is_good(report.verdict);
    judgement.samples = report.samples;
    judgement.failures = report.failures;
    judgement.message = report.message;
    if (report.worst) {
        const Finding& worst = *report.worst;
        judgement.worst = worst.error;
        judgement.worst_call = format_call(c, worst.input, worst.mask ? &*worst.mask : nullptr);
        judgement.got = format_result(c, worst.got);
        if (worst.in_domain) judgement.want = format_result(c, worst.want);
        judgement.replay = replay_command(c, worst, replay);
    }
    if (!judgement.good) judgement.explanation = explain_failure(report, replay);
    return judgement;
}

} // namespace

Subject::Subject(const Case& c, const CheckOptions& options, std::shared_ptr<const EdgePool> pool,
                 std::span<const CsvInput> regressions)
    : case_(c),
      sampler_(c, options.seed.value_or(default_seed(c)), std::move(pool),
               options.pins.empty() ? options.pins : options.pins / (c.name + ".csv"),
               options.worst.empty() ? options.worst : options.worst / (c.name + ".csv"), regressions),
      records_(draw_records(c, sampler_, 0,
                            std::max(options.samples.value_or(default_samples(c)), sampler_.fixed_count()))),
      truths_(truths(c, records_)) {}

Subject::Ran Subject::run(gpu::Device& device, glsl::Spirv words, const std::string& text,
                          CheckReport& report) {
    gpu::Kernel kernel = device.kernel(words, case_.name);
    Outputs outputs = run_standalone(device, kernel, case_, records_);
    report.samples = records_.size();
    Ran ran;
    ran.text = text;
    ran.words = std::move(words);
    ran.judged =
        judge_all(case_, records_, std::move(outputs.words), truths_, ran_ ? &ran_->judged : nullptr);
    add_judged(case_, records_, 0, ran.judged, report);
    add_complaint(case_, records_, 0, outputs, report);
    return ran;
}

Moved Subject::compare(const Ran& before, const Ran& after) const {
    const Type type = case_.reference.result;
    const auto components = static_cast<std::size_t>(type.components);
    Moved moved;
    std::optional<std::size_t> at;
    for (std::size_t i = 0; i < records_.size(); ++i) {
        const std::uint32_t* a = before.judged.results.data() + i * components;
        const std::uint32_t* b = after.judged.results.data() + i * components;
        if (std::equal(a, a + components, b)) continue;
        ++moved.samples;
        double largest = 0;
        for (std::size_t k = 0; k < components; ++k)
            largest = std::max(largest, difference(type.scalar, a[k], b[k]));
        if (at && largest <= moved.largest) continue;
        at = i;
        moved.largest = largest;
    }
    if (!at) return moved;
    const auto result = [&](const Ran& ran) {
        return format_result(case_, std::span(ran.judged.results).subspan(*at * components, components));
    };
    moved.call = format_call(case_, records_.input(*at), records_.mask(*at));
    moved.before = result(before);
    moved.after = result(after);
    return moved;
}

Judgement Subject::judge(gpu::Device& device, const std::string& text, const std::string& before,
                         const std::string& folder, const std::string& replay) {
    CheckReport report;
    report.kernel = &case_;
    report.seed = sampler_.seed();
    try {
        if (before.empty()) {
            ran_.reset();
        } else if (!ran_ || ran_->text != before) { // a new process, or a state that was never shown
            CheckReport ignored = report;
            ran_ = run(device, compile_standalone_text(case_, before, folder), before, ignored);
        }
        glsl::Spirv words = compile_standalone_text(case_, text, folder);
        if (ran_ && glsl::without_names(words) == glsl::without_names(ran_->words)) {
            ran_->text = text;
            Judgement same;
            same.same_code = true;
            return same;
        }
        Ran ran = run(device, std::move(words), text, report);
        // What a kernel that must fail answers where it divides by zero is undefined.
        const bool repeatable = case_.fails.empty() && report.message.empty();
        expect_what_the_table_says(report);
        Judgement judgement = judgement_of(report, replay);
        judgement.ran = true;
        if (repeatable) judgement.results = hash_of(case_, ran.judged.results);
        if (ran_) judgement.moved = compare(*ran_, ran);
        ran_ = std::move(ran);
        return judgement;
    } catch (const CompileError& error) {
        report.verdict = Verdict::compile_error;
        report.message = error.what();
    } catch (const KernelTimeout& error) {
        report.verdict = Verdict::timeout;
        report.message = error.what();
    }
    Judgement judgement = judgement_of(report, replay);
    judgement.device_lost = report.verdict == Verdict::timeout;
    return judgement;
}

std::uint64_t hash_of(const Case& c, std::span<const std::uint32_t> results) {
    std::vector<std::uint32_t> words(results.begin(), results.end());
    if (c.reference.result.scalar == Scalar::float32)
        for (std::uint32_t& word : words)
            if (std::isnan(std::bit_cast<float>(word))) word = 0x7fc00000u;
    const std::string_view bytes(reinterpret_cast<const char*>(words.data()),
                                 words.size() * sizeof(std::uint32_t));
    const std::uint64_t value = hash(bytes);
    return value == 0 ? 1 : value; // 0 says that there is none
}

} // namespace gnomon::watch
