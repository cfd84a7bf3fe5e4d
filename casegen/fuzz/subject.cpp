#include "casegen/fuzz/subject.h"

#include "casegen/check.h"
#include "casegen/measure/inputs.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::fuzz {
namespace {

Records records_of(const Case& c, std::span<const Input> inputs) {
    Records records(c);
    for (const Input& input : inputs) records.add(input.words, &input.mask);
    return records;
}

/// Truths that nobody asks for again: not worth files.
std::vector<Truth> passing_truths(const Case& c, const Records& records) {
    return measure::truths_on(c, records, 1, {});
}

} // namespace

std::string failure_of(const Outputs& outputs) {
    if (std::ranges::find(outputs.unwritten, 1) != outputs.unwritten.end()) return unwritten;
    if (outputs.stray_write) return stray_write;
    return outputs.unstable ? unstable : "";
}

Subject::Subject(const Case& c, const glsl::Sources& sources, gpu::Device& device)
    : case_(c), device_(device), kernel_(device.kernel(compile_standalone(c, sources), c.name)), quick_(c) {}

Outputs Subject::run(const Records& records) { return run_standalone(device_, kernel_, case_, records); }

Outputs Subject::run(std::span<const Input> inputs) { return run(records_of(case_, inputs)); }

std::size_t Subject::isolate(const Records& records, const std::string& failure) {
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const std::span<const std::uint32_t> words = records.input(i);
        inputs.push_back({{words.begin(), words.end()}, records.mask(i) ? *records.mask(i) : Mask()});
    }
    std::size_t begin = 0, end = inputs.size();
    while (end - begin > 1) {
        const std::size_t middle = begin + (end - begin) / 2;
        const auto fails = [&](std::size_t from, std::size_t to) {
            return failure_of(run(std::span(inputs).subspan(from, to - from))) == failure;
        };
        if (fails(begin, middle))
            end = middle;
        else if (fails(middle, end))
            begin = middle;
        else
            return inputs.size();
    }
    return begin;
}

std::vector<std::string> Subject::failures(std::span<const Input> inputs) {
    const Records records = records_of(case_, inputs);
    const Outputs outputs = run(records);
    return failures_of(case_, records, outputs, passing_truths(case_, records));
}

std::optional<Regression> Subject::shrunk(const Input& input, const std::string& failure,
                                          const std::string& found) {
    const bool of_dispatch = failure == unwritten || failure == stray_write || failure == unstable;
    const auto still_fails = [&](std::span<const Input> candidates) {
        std::vector<bool> fails(candidates.size());
        if (of_dispatch) { // one by one: which of them it was no result tells
            for (std::size_t i = 0; i < candidates.size(); ++i)
                fails[i] = failure_of(run(candidates.subspan(i, 1))) == failure;
            return fails;
        }
        const std::vector<std::string> each = failures(candidates);
        for (std::size_t i = 0; i < each.size(); ++i) fails[i] = each[i] == failure;
        return fails;
    };
    ShrinkOptions options;
    if (case_.reference.truth) options = {512, 40, 0}; // a truth takes as long as a thousand kernels
    if (of_dispatch) options = {64, 20, 0};
    const auto fails_alone = [&](const Input& one) -> bool {
        return still_fails(std::span(&one, 1)).front();
    };
    if (!fails_alone(input)) return {};
    Input simplest = shrink(case_, input, still_fails, options).input;
    if (!fails_alone(simplest)) simplest = input; // it failed among the other candidates only

    Regression regression{case_.name, failure, simplest, {}, {}, to_string(case_.tolerance), found};
    const Outputs outputs = run(std::span(&simplest, 1));
    const Mask* mask = case_.reference.takes_mask ? &simplest.mask : nullptr;
    const Arguments with = arguments(case_, simplest.words, mask);
    regression.got = failure == unwritten ? "nothing" : format_result(case_, outputs.words);
    regression.want = format_want(case_, with);
    return regression;
}

} // namespace gnomon::fuzz
