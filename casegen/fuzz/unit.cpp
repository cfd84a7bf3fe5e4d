#include "casegen/fuzz/unit.h"

#include "casegen/check.h"
#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/subject.h"
#include "casegen/measure/inputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace gnomon::fuzz {
namespace {

constexpr std::size_t batch_size = std::size_t{1} << 16, batches_per_unit = 4;
constexpr std::size_t truth_batch_size = 128; ///< of references in multiprecision, a millisecond each
constexpr std::uint64_t units_per_epoch = 4;  ///< which share their masks

std::size_t batch_size_of(const Case& c) {
    if (const Chain* chain = find_chain(c)) return chain->batch;
    return c.reference.truth ? truth_batch_size : batch_size;
}

std::uint64_t unit_seed(std::uint64_t seed, const Unit& unit) {
    return Random(seed ^ hash(unit.kernel->name), unit.round).bits();
}

std::vector<Input> regressions_of(const FuzzerOptions& options, const Case& c) {
    std::vector<Input> inputs;
    if (const auto found = options.regressions.find(c.name); found != options.regressions.end())
        for (const Regression& regression : found->second) inputs.push_back(regression.input);
    return inputs;
}

/// Of a failure so many inputs of a batch are tried alone before it is told as one that only happens among
/// others.
constexpr std::size_t most_tried = 64;

/// What no file can replay: a failure among the other inputs of a batch, and not alone.
Regression only_together(const Case& c, const std::string& failure, const std::string& found) {
    return {c.name,
            failure + ", among other inputs only",
            {},
            "the inputs that were tried do not fail alone: their place in the dispatch decides, or chance",
            {},
            to_string(c.tolerance),
            found};
}

Input input_of(const Records& records, std::size_t i) {
    const std::span<const std::uint32_t> words = records.input(i);
    return {{words.begin(), words.end()}, records.mask(i) ? *records.mask(i) : Mask()};
}

} // namespace

std::size_t unit_size(const Case& c) {
    const Chain* chain = find_chain(c);
    return chain ? chain->batch * chain->batches : batch_size_of(c) * batches_per_unit;
}

struct Fuzzer::Impl {
    FuzzerOptions options;
    gpu::Device device;
    std::map<const Case*, Subject> subjects;
    std::map<const Chain*, Judge> judges;
    std::map<std::uint64_t, std::shared_ptr<const EdgePool>> pools;

    explicit Impl(FuzzerOptions given) : options(std::move(given)), device(options.device) {}

    Subject& subject(const Case& c) {
        const auto found = subjects.find(&c);
        return found != subjects.end() ? found->second
                                       : subjects.try_emplace(&c, c, options.sources, device).first->second;
    }

    const Judge& judge(const Chain& chain) {
        const auto found = judges.find(&chain);
        return found != judges.end()
                   ? found->second
                   : judges.try_emplace(&chain, chain.judge(options.sources, device)).first->second;
    }

    std::shared_ptr<const EdgePool> pool(std::uint64_t epoch) {
        std::shared_ptr<const EdgePool>& pool = pools[epoch];
        if (!pool) pool = make_fuzz_pool(options.seed, epoch);
        while (pools.size() > 2)
            pools.erase(pools.begin()->first == epoch ? std::next(pools.begin()) : pools.begin());
        return pool;
    }

    UnitResult run_chain(const Chain& chain, const Unit& unit, const std::set<std::string>& known,
                         std::atomic<std::uint32_t>& batch);
};

namespace {

/// A unit's batches, one after the other: what each draws depends on what the ones before it were judged to
/// be.
class Batches {
public:
    Batches(const FuzzerOptions& options, const Unit& unit, std::shared_ptr<const EdgePool> pool)
        : case_(*unit.kernel), unit_(unit), seed_(unit_seed(options.seed, unit)), worst_(case_) {
        const auto file = [&](const std::filesystem::path& folder) {
            return folder.empty() ? folder : folder / (case_.name + ".csv");
        };
        const std::vector<Input> rows = regressions_of(options, case_);
        regressions_ = rows.size();
        sampler_.emplace(case_, seed_, std::move(pool), file(options.pins), file(options.worst), rows);
        draw_.emplace(case_, *sampler_, seed_);
        // Regressions come first in every unit, so that each knows which failures are on file.
        fixed_ = unit.round == 0 ? sampler_->fixed_count() : regressions_;
    }

    std::size_t total() const { return fixed_ + unit_.evaluations; }
    bool is_regression(std::size_t index) const { return index < regressions_; }

    Records batch(std::size_t number) const {
        const std::size_t begin = number * batch_size_of(case_);
        const std::size_t end = std::min(total(), begin + batch_size_of(case_));
        Records records(case_);
        records.reserve(end - begin);
        std::size_t i = begin;
        for (; i < std::min(end, fixed_); ++i)
            records.add_with([&](std::span<std::uint32_t> words) { return sampler_->draw(i, words); });
        while (i < end) {
            const std::size_t in_block = (i - fixed_) % draw_->block_size();
            const std::size_t count = std::min(end - i, draw_->block_size() - in_block);
            records.add_block(count, [&](std::span<std::uint32_t> rows) {
                return draw_->draw_block(i - fixed_, i - fixed_ + count, worst_.rows(), rows,
                                         records.stride());
            });
            i += count;
        }
        return records;
    }

    void add(const Records& records, std::size_t i, double error) {
        const std::span<const std::uint32_t> words = records.input(i);
        worst_.add({{words.begin(), words.end()}, records.mask(i), error, true});
    }
    /// Whether `add` would do anything.
    bool matters(double error) const {
        return error > 0 && (worst_.rows().size() < worst::most_rows || error >= worst_.rows().back().error);
    }
    const std::vector<worst::Row>& worst() const { return worst_.rows(); }

private:
    const Case& case_;
    Unit unit_;
    std::uint64_t seed_;
    std::optional<Sampler> sampler_;
    std::optional<Draw> draw_;
    std::size_t regressions_ = 0, fixed_ = 0;
    worst::Worst worst_;
};

/// The same of a chain: nothing is known of how wrong an input nearly is.
class ChainBatches {
public:
    ChainBatches(const Chain& chain, const FuzzerOptions& options, const Unit& unit,
                 std::shared_ptr<const EdgePool> pool)
        : chain_(chain), unit_(unit), seed_(unit_seed(options.seed, unit)) {
        if (!chain.draw)
            drawn_.emplace(options, unit, std::move(pool));
        else
            regressions_ = regressions_of(options, chain.described);
    }

    std::size_t total() const { return drawn_ ? drawn_->total() : regressions_.size() + unit_.evaluations; }
    bool is_regression(std::size_t index) const {
        return drawn_ ? drawn_->is_regression(index) : index < regressions_.size();
    }
    std::vector<Input> batch(std::size_t number) const {
        std::vector<Input> inputs;
        if (drawn_) {
            const Records records = drawn_->batch(number);
            for (std::size_t i = 0; i < records.size(); ++i) inputs.push_back(input_of(records, i));
            return inputs;
        }
        const std::size_t begin = number * chain_.batch, end = std::min(total(), begin + chain_.batch);
        for (std::size_t i = begin; i < end; ++i)
            inputs.push_back(i < regressions_.size()
                                 ? regressions_[i]
                                 : chain_.draw(seed_, i - regressions_.size(), 1).front());
        return inputs;
    }

private:
    const Chain& chain_;
    Unit unit_;
    std::uint64_t seed_;
    std::optional<Batches> drawn_; ///< of chains over masks
    std::vector<Input> regressions_;
};

/// Judges one batch: feeds the worst ones to those that follow, and returns the failures that nobody knew,
/// each with the first records that show it.
std::map<std::string, std::vector<std::size_t>> judge_batch(Subject& subject, const Records& records,
                                                            const Outputs& outputs, Batches& batches,
                                                            const std::set<std::string>& known) {
    const Case& c = subject.kernel();
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    const std::vector<Truth> truths = measure::truths_on(c, records, 1, {});
    std::map<std::string, std::vector<std::size_t>> firsts;
    for (const std::size_t i : subject.quick().to_look_at(records, outputs.words)) {
        const Arguments with = arguments(c, records.input(i), records.mask(i));
        const std::span<const std::uint32_t> got(outputs.words.data() + i * components, components);
        const Agreement agreement = judge(c, with, got, truths.empty() ? nullptr : &truths[i]);
        if (!agreement.pass) {
            const std::string failure = failure_of(c, with, got, agreement);
            if (known.contains(failure)) continue;
            if (std::vector<std::size_t>& those = firsts[failure]; those.size() < most_tried)
                those.push_back(i);
        } else if (batches.matters(agreement.error)) {
            batches.add(records, i, agreement.error);
        }
    }
    return firsts;
}

} // namespace

UnitResult Fuzzer::Impl::run_chain(const Chain& chain, const Unit& unit, const std::set<std::string>& known,
                                   std::atomic<std::uint32_t>& batch) {
    const Judge& judge = this->judge(chain);
    const ChainBatches batches(chain, options, unit, pool(unit.round / units_per_epoch));
    UnitResult result;
    std::set<std::string> told = known;
    const std::size_t end = unit.batches.value_or(std::numeric_limits<std::size_t>::max());
    for (std::size_t number = 0; result.evaluations < batches.total() && number < end; ++number) {
        batch = static_cast<std::uint32_t>(number);
        const std::vector<Input> inputs = batches.batch(number);
        const std::vector<std::string> failures = judge(inputs);
        std::map<std::string, std::size_t> tried;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const std::string& failure = failures[i];
            if (failure.empty() || told.contains(failure)) continue;
            const bool on_file = batches.is_regression(result.evaluations + i);
            const auto fails_alone = [&](const Input& one) {
                return judge(std::span(&one, 1)).front() == failure;
            };
            Input input = inputs[i];
            const std::string found = fmt::format("fuzzing, seed {:#x}, round {}, as {}", options.seed,
                                                  unit.round, chain.format(input));
            if (!on_file && unit.shrink) {
                if (tried[failure]++ >= most_tried) continue;
                if (!fails_alone(input)) {
                    Regression regression = only_together(chain.described, failure, found);
                    if (told.insert(regression.failure).second)
                        result.found.push_back({std::move(regression), false});
                    continue;
                }
                input = chain.shrink(input, [&](std::span<const Input> candidates) {
                    std::vector<bool> fails;
                    for (const std::string& each : judge(candidates)) fails.push_back(each == failure);
                    return fails;
                });
                if (!fails_alone(input)) input = inputs[i]; // it failed among the other candidates only
            }
            told.insert(failure);
            Found& told_of = result.found.emplace_back();
            told_of.regression.kernel = chain.described.name;
            told_of.regression.failure = failure;
            told_of.regression.input = std::move(input);
            told_of.regression.got = failure;
            told_of.regression.want = fmt::format("{}", fmt::join(chain.invariants, "; "));
            told_of.regression.allowed = "nothing else";
            told_of.regression.found = found;
            told_of.on_file = on_file;
        }
        result.evaluations += inputs.size();
    }
    return result;
}

Fuzzer::Fuzzer(FuzzerOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Fuzzer::~Fuzzer() = default;

UnitResult Fuzzer::run(const Unit& unit, const std::set<std::string>& known,
                       std::atomic<std::uint32_t>& batch) {
    const Case& c = *unit.kernel;
    batch = 0;
    if (const Chain* chain = find_chain(c)) return impl_->run_chain(*chain, unit, known, batch);
    Subject& subject = impl_->subject(c);
    Batches batches(impl_->options, unit, impl_->pool(unit.round / units_per_epoch));
    UnitResult result;
    std::set<std::string> told = known;
    const auto found_as = [&](const Input& input) {
        return fmt::format("fuzzing, seed {:#x}, round {}, as {}", impl_->options.seed, unit.round,
                           format_call(c, input.words, c.reference.takes_mask ? &input.mask : nullptr));
    };
    const auto as_met = [&](const Records& records, const Outputs& outputs, std::size_t i,
                            const std::string& failure) {
        const auto components = static_cast<std::size_t>(c.reference.result.components);
        const Input input = input_of(records, i);
        return Regression{
            c.name,
            failure,
            input,
            failure == unwritten
                ? "nothing"
                : format_result(c, std::span(outputs.words).subspan(i * components, components)),
            format_want(c, arguments(c, records.input(i), records.mask(i))),
            to_string(c.tolerance),
            found_as(input)};
    };
    const auto tell_together = [&](const std::string& failure, const std::string& found) {
        Regression regression = only_together(c, failure, found);
        if (told.insert(regression.failure).second) result.found.push_back({std::move(regression), false});
    };
    const auto tell = [&](const Records& records, const Outputs& outputs,
                          const std::vector<std::size_t>& those, const std::string& failure) {
        const bool on_file = batches.is_regression(result.evaluations + those.front());
        if (on_file || !unit.shrink) {
            told.insert(failure);
            result.found.push_back({as_met(records, outputs, those.front(), failure), on_file});
            return;
        }
        for (const std::size_t i : those) {
            const Input input = input_of(records, i);
            std::optional<Regression> alone = subject.shrunk(input, failure, found_as(input));
            if (!alone) continue;
            told.insert(failure);
            result.found.push_back({std::move(*alone), false});
            return;
        }
        tell_together(failure, found_as(input_of(records, those.front())));
    };
    const std::size_t end = unit.batches.value_or(std::numeric_limits<std::size_t>::max());
    for (std::size_t number = 0; result.evaluations < batches.total() && number < end; ++number) {
        batch = static_cast<std::uint32_t>(number);
        const Records records = batches.batch(number);
        const Outputs outputs = subject.run(records);
        if (const std::string failure = failure_of(outputs); !failure.empty()) {
            if (!told.contains(failure)) {
                const std::size_t at = subject.isolate(records, failure);
                if (at < records.size())
                    tell(records, outputs, {at}, failure);
                else
                    tell_together(failure, fmt::format("fuzzing, seed {:#x}, round {}, batch {}",
                                                       impl_->options.seed, unit.round, number));
            }
        } else {
            for (const auto& [of_record, those] : judge_batch(subject, records, outputs, batches, told))
                tell(records, outputs, those, of_record);
        }
        result.evaluations += records.size();
    }
    if (!batches.worst().empty()) {
        const worst::Row& row = batches.worst().front();
        result.worst_error = row.error;
        result.worst = {row.words, row.mask ? *row.mask : Mask()};
    }
    return result;
}

std::vector<Input> Fuzzer::inputs(const Unit& unit, std::size_t batch) {
    if (const Chain* chain = find_chain(*unit.kernel))
        return ChainBatches(*chain, impl_->options, unit, impl_->pool(unit.round / units_per_epoch))
            .batch(batch);
    Subject& subject = impl_->subject(*unit.kernel);
    Batches batches(impl_->options, unit, impl_->pool(unit.round / units_per_epoch));
    for (std::size_t number = 0; number < batch; ++number) {
        const Records records = batches.batch(number);
        const Outputs outputs = subject.run(records);
        if (failure_of(outputs).empty()) judge_batch(subject, records, outputs, batches, {});
    }
    const Records records = batches.batch(batch);
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < records.size(); ++i) inputs.push_back(input_of(records, i));
    return inputs;
}

void Fuzzer::dispatch(const Unit& unit, const Part& part) {
    const std::vector<Input> all = inputs(unit, part.batch);
    if (const Chain* chain = find_chain(*unit.kernel)) {
        const std::size_t begin = std::min(part.begin, all.size()), end = std::min(part.end, all.size());
        if (begin < end) impl_->judge (*chain)(std::span(all).subspan(begin, end - begin));
        return;
    }
    Records records(*unit.kernel);
    for (std::size_t i = part.begin; i < std::min(part.end, all.size()); ++i)
        records.add(all[i].words, &all[i].mask);
    impl_->subject(*unit.kernel).run(records);
}

} // namespace gnomon::fuzz
